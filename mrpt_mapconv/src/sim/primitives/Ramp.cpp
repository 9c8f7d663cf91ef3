#include "../MeshBuilder.h"
#include "../SectionKeys.h"

namespace mrpt_mapconv::sim
{
namespace
{
/** A wedge that rises evenly from min z, where it has no thickness, to max z. min, max: corners
 * x y z [m]; direction: it rises towards +x, -x, +y or -y. */
class Ramp : public Primitive
{
 public:
  Ramp(const Corners& corners, Direction direction) : m_corners(corners), m_direction(direction) {}

  static std::unique_ptr<Primitive> read(params::StrictSection& section)
  {
    return std::make_unique<Ramp>(readCorners(section), readDirection(section));
  }

  Footprint footprint() const override
  {
    return {m_corners.min.x, m_corners.min.y, m_corners.max.x, m_corners.max.y};
  }

  void appendMesh(Mesh& mesh) const override
  {
    MeshBuilder build(mesh);
    const double thin = m_direction.backwards ? 1 : 0, thick = 1 - thin;
    const auto a = vertex(build, thin, 0, 0), b = vertex(build, thin, 1, 0);
    const auto c = vertex(build, thick, 0, 0), d = vertex(build, thick, 1, 0);
    const auto e = vertex(build, thick, 0, 1), f = vertex(build, thick, 1, 1);
    build.quad(a, b, d, c);
    build.quad(a, b, f, e);
    build.quad(c, d, f, e);
    build.triangle(a, c, e);
    build.triangle(b, d, f);
  }

  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    const auto& [min, max] = m_corners;
    if (x < min.x || x > max.x || y < min.y || y > max.y) return;
    const double length = m_direction.alongY ? max.y - min.y : max.x - min.x;
    const double along = m_direction.alongY ? y - min.y : x - min.x;
    const double share = (m_direction.backwards ? length - along : along) / length;
    const double height = max.z - min.z;
    if (share > 0) solids.push_back({min.z, min.z + share * height, height / length});
  }

 private:
  /** At shares of the ramp's length (in the positive direction of its axis), width and height. */
  std::uint32_t vertex(MeshBuilder& build, double along, double across, double up) const
  {
    const auto& [min, max] = m_corners;
    const double u = m_direction.alongY ? across : along, v = m_direction.alongY ? along : across;
    return build.vertex(u > 0 ? max.x : min.x, v > 0 ? max.y : min.y, up > 0 ? max.z : min.z);
  }

  Corners m_corners;
  Direction m_direction;
};

const PrimitiveKind kKind("ramp", Ramp::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
