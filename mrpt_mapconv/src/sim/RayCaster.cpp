#include <mrpt_mapconv/sim/RayCaster.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "EmbreeBodies.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TVector3D;

namespace
{
struct Releaser
{
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, Releaser>;
using SceneHandle = std::unique_ptr<RTCSceneTy, Releaser>;

Hit hitOf(const RTCRayHit& answer)
{
  Hit hit;
  hit.range = answer.ray.tfar;
  hit.primitive = static_cast<std::int32_t>(answer.hit.geomID);
  TVector3D normal(answer.hit.Ng_x, answer.hit.Ng_y, answer.hit.Ng_z);
  const TVector3D direction = directionOf(answer.ray);
  const double along = normal.x * direction.x + normal.y * direction.y + normal.z * direction.z;
  normal *= (along > 0 ? -1 : 1) / normal.norm();
  hit.normal = {static_cast<float>(normal.x), static_cast<float>(normal.y),
                static_cast<float>(normal.z)};
  return hit;
}

Hit castAt(RTCScene scene, const Ray& ray, float minRange, float maxRange)
{
  RTCRayHit query{};
  query.ray.org_x = ray.origin.x;
  query.ray.org_y = ray.origin.y;
  query.ray.org_z = ray.origin.z;
  query.ray.dir_x = ray.direction.x;
  query.ray.dir_y = ray.direction.y;
  query.ray.dir_z = ray.direction.z;
  query.ray.tnear = minRange;
  query.ray.tfar = maxRange;
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  Way way;
  way.key = ray.key;
  rtcInitIntersectContext(&way.context);
  rtcIntersect1(scene, &way.context, &query);
  return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? Hit{} : hitOf(query);
}
}  // namespace

/** Bodies that move have a scene of their own: it is built anew whenever they do. */
struct RayCaster::Scene
{
  explicit Scene(const World& w);
  SceneHandle newScene();
  void attachTriangles(unsigned id);
  void attach(const SceneHandle& to, RTCGeometry geometry, unsigned id);
  void commit(const SceneHandle& changed);
  void moveTo(double seconds);

  const World& world;
  Device device;
  SceneHandle standing, moving;  // `moving` is null if nothing moves
  // by primitive; null for those of triangles
  std::vector<Placed> curved;
  std::vector<const Foliage*> foliage;
};

RayCaster::Scene::Scene(const World& w)
    : world(w), device(rtcNewDevice(nullptr)), curved(w.size()), foliage(w.size())
{
  if (!device) throw std::runtime_error("Embree does not start (no memory, or an old processor)");
  standing = newScene();
  for (unsigned id = 0; id < w.size(); ++id)
  {
    const Primitive& body = w.primitive(id);
    curved[id].surface = body.curved();
    foliage[id] = body.foliage();
    if (foliage[id])
      attach(standing, newGeometry(device.get(), foliage[id]), id);
    else if (!body.curved())
      attachTriangles(id);
    else if (!body.motion())
      attach(standing, newGeometry(device.get(), curved[id]), id);
    else
    {
      if (!moving) moving = newScene();
      attach(moving, newGeometry(device.get(), curved[id]), id);
    }
  }
  commit(standing);
  moveTo(0);
}

SceneHandle RayCaster::Scene::newScene()
{
  SceneHandle scene(rtcNewScene(device.get()));
  // so that no ray slips through an edge between two triangles, and for ranges that are right to
  // 0.1 mm also where a ray meets a far floor under a small angle
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  return scene;
}

void RayCaster::Scene::commit(const SceneHandle& changed)
{
  // One thread builds, so that the tree and its answers are always the same; the device's own
  // option for this would bind all of the process to one thread.
  tbb::task_arena(1).execute([&] { rtcCommitScene(changed.get()); });
  if (const RTCError error = rtcGetDeviceError(device.get()); error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree could not build the world: its error " +
                             std::to_string(static_cast<int>(error)));
}

void RayCaster::Scene::moveTo(double seconds)
{
  if (!moving) return;
  for (unsigned id = 0; id < world.size(); ++id)
  {
    const Motion* motion = world.primitive(id).motion();
    if (!motion) continue;
    curved[id].shift = motion->shiftAt(seconds);
    rtcCommitGeometry(rtcGetGeometry(moving.get(), id));
  }
  commit(moving);
}

void RayCaster::Scene::attach(const SceneHandle& to, RTCGeometry geometry, unsigned id)
{
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(to.get(), geometry, id);
  rtcReleaseGeometry(geometry);
}

void RayCaster::Scene::attachTriangles(unsigned id)
{
  Mesh mesh;
  world.primitive(id).appendMesh(mesh);
  const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  const auto fill = [&](RTCBufferType type, RTCFormat format, const auto& items)
  {
    using Item = typename std::decay_t<decltype(items)>::value_type;
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Item), items.size());
    if (!buffer) throw std::bad_alloc();
    std::copy(items.begin(), items.end(), static_cast<Item*>(buffer));
  };
  fill(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices);
  fill(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
  attach(standing, geometry, id);
}

RayCaster::RayCaster(const World& world) : m_scene(std::make_unique<Scene>(world)) {}
RayCaster::~RayCaster() = default;

const World& RayCaster::world() const { return m_scene->world; }

void RayCaster::moveTo(double seconds) { m_scene->moveTo(seconds); }

Hit RayCaster::cast(const Ray& ray, float minRange, float maxRange) const
{
  const Hit standing = castAt(m_scene->standing.get(), ray, minRange, maxRange);
  if (!m_scene->moving) return standing;
  const Hit moving =
      castAt(m_scene->moving.get(), ray, minRange, std::min(maxRange, standing.range));
  return moving.primitive >= 0 ? moving : standing;
}

void RayCaster::cast(const std::vector<Ray>& rays, float minRange, float maxRange,
                     std::vector<Hit>& hits) const
{
  hits.resize(rays.size());
  std::transform(rays.begin(), rays.end(), hits.begin(),
                 [&](const Ray& ray) { return cast(ray, minRange, maxRange); });
}

}  // namespace mrpt_mapconv::sim
