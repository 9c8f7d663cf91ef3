// Speed of the ray caster on one core, in a world of 1000 primitives, as a ratio to a plain loop
// over all triangles of the same world in this process (target: >= 1 million rays per second), and
// of the truth layers. Best of five.
//
//   bench_raycast [FEWER]    FEWER: divides the number of rays, to see quickly that it works
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/sim/RayCaster.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <sstream>

using namespace mrpt_mapconv;

namespace
{
template <class Task>
double seconds(const Task& task)
{
  double best = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 5; ++run)
  {
    const auto start = std::chrono::steady_clock::now();
    task();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count());
  }
  return best;
}

/** Hilly ground and 999 bodies of all kinds on 100 x 100 m. */
sim::World thousandBodies()
{
  std::mt19937 random(1);
  const auto between = [&](double low, double high)
  { return std::uniform_real_distribution<>(low, high)(random); };
  std::ostringstream text;
  text << "[world]\nbounds = -50 -50 -5 50 50 10\n[heightField.ground]\nmin = -50 -50\n"
          "max = 50 50\ncell = 1\nsolid = below\namplitude = 1\nwavelength = 20\n";
  for (int i = 1; i < 1000; ++i)
  {
    const double x = between(-49, 47), y = between(-49, 47), size = between(0.3, 2);
    std::ostringstream corners;
    corners << "min = " << x << ' ' << y << " -2\nmax = " << x + size << ' ' << y + size << ' '
            << between(0, 3) << '\n';
    switch (i % 5)
    {
      case 0:
        text << "[box.b" << i << "]\n" << corners.str() << "yaw = " << between(0, 90) << '\n';
        break;
      case 1:
        text << "[ramp.b" << i << "]\n" << corners.str() << "direction = +x\n";
        break;
      case 2:
        text << "[stairs.b" << i << "]\n" << corners.str() << "direction = -y\nsteps = 8\n";
        break;
      case 3:
        text << "[cylinder.b" << i << "]\nbase = " << x << ' ' << y << " -2\nradius = " << size / 4
             << "\nheight = 5\n";
        break;
      default:
        text << "[sphere.b" << i << "]\ncentre = " << x << ' ' << y << ' ' << between(0, 4)
             << "\nradius = " << size / 2 << '\n';
    }
  }
  return sim::World::fromIni(mrpt::config::CConfigFileMemory(text.str()), {});
}

/** Turns of a lidar with 16 beams, from places in the world. */
std::vector<sim::Ray> lidarRays(std::size_t count)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<float> place(-45, 45);
  std::vector<sim::Ray> rays;
  mrpt::math::TPoint3Df origin;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i % 14400 == 0) origin = {place(random), place(random), 2.5f};
    const float yaw = float(i / 16 % 900) * 0.4f * 0.0174533f;
    const float pitch = (float(i % 16) * 2 - 15) * 0.0174533f;
    rays.push_back(
        {origin,
         {std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch), std::sin(pitch)}});
  }
  return rays;
}

sim::Mesh meshOf(const sim::World& world)
{
  sim::Mesh all;
  for (std::size_t i = 0; i < world.size(); ++i)
  {
    sim::Mesh mesh;
    world.primitive(i).appendMesh(mesh);
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (auto triangle : mesh.triangles)
    {
      for (auto& corner : triangle) corner += first;
      all.triangles.push_back(triangle);
    }
  }
  return all;
}

/** Range of the first triangle that a ray meets, by looking at all of them (Moeller, Trumbore). */
float castAtAll(const sim::Mesh& mesh, const sim::Ray& ray)
{
  using Vector = mrpt::math::TPoint3Df;
  const auto cross = [](const Vector& a, const Vector& b)
  { return Vector(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); };
  const auto dot = [](const Vector& a, const Vector& b)
  { return a.x * b.x + a.y * b.y + a.z * b.z; };
  const auto corner = [&](std::uint32_t i)
  { return Vector(mesh.vertices[i][0], mesh.vertices[i][1], mesh.vertices[i][2]); };
  float first = std::numeric_limits<float>::infinity();
  for (const auto& triangle : mesh.triangles)
  {
    const Vector a = corner(triangle[0]);
    const Vector ab = corner(triangle[1]) - a, ac = corner(triangle[2]) - a;
    const Vector p = cross(ray.direction, ac), s = ray.origin - a, q = cross(s, ab);
    const float scale = 1 / dot(ab, p);
    const float u = dot(s, p) * scale, v = dot(ray.direction, q) * scale;
    const float range = dot(ac, q) * scale;
    if (u >= 0 && v >= 0 && u + v <= 1 && range > 0 && range < first) first = range;
  }
  return first;
}

/** How many of the ranges agree; curved bodies are only near their triangles. */
double shareAlike(const std::vector<float>& slow, const std::vector<sim::Hit>& fast)
{
  std::size_t alike = 0;
  for (std::size_t i = 0; i < slow.size(); ++i)
    alike += slow[i] == fast[i].range || std::abs(slow[i] - fast[i].range) < 0.05f;
  return double(alike) / double(slow.size());
}
}  // namespace

int main(int argc, char** argv)
{
  const std::size_t fewer = argc > 1 ? std::max(1ul, std::strtoul(argv[1], nullptr, 10)) : 1;
  const sim::World world = thousandBodies();
  const sim::RayCaster caster(world);
  const sim::Mesh mesh = meshOf(world);
  const auto rays = lidarRays(1440000 / fewer);
  const std::vector<sim::Ray> few(
      rays.begin(), rays.begin() + std::ptrdiff_t(std::min(rays.size(), 1000 / fewer + 1)));

  std::vector<sim::Hit> hits;
  const double fast = double(rays.size()) / seconds([&] { caster.cast(rays, 0.1f, 100, hits); });
  std::vector<float> ranges(few.size());
  const double slow = double(few.size()) / seconds(
                                               [&]
                                               {
                                                 for (std::size_t i = 0; i < few.size(); ++i)
                                                   ranges[i] = castAtAll(mesh, few[i]);
                                               });
  std::printf("%zu primitives, %zu triangles, one thread\n", world.size(), mesh.triangles.size());
  std::printf("ray caster   %8.3f million rays/s\n", fast * 1e-6);
  std::printf("plain loop   %8.3f million rays/s\n", slow * 1e-6);
  std::printf("ratio        %8.0f\n", fast / slow);
  const double alike = shareAlike(ranges, hits);
  std::printf("ranges alike %8.1f %%\n", alike * 100);

  const auto frame = sim::frameOf(world, fewer > 1 ? 1.0 : 0.2);
  const double truth = seconds([&] { sim::truthLayers(world, frame, {}, 1); });
  std::printf("truth        %8.3f million cells/s, one thread\n",
              double(frame.size()) / truth * 1e-6);
  return alike > 0.95 ? 0 : 1;
}
