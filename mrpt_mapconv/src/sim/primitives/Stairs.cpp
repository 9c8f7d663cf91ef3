#include <algorithm>
#include <cmath>

#include "../MeshBuilder.h"
#include "../SectionKeys.h"

namespace mrpt_mapconv::sim
{
namespace
{
constexpr std::int32_t kMostSteps = 10000;

/** Solid stairs of even steps; the last tread is at max z. min, max: corners x y z [m]; direction:
 * they rise towards +x, -x, +y or -y; steps: their number. */
class Stairs : public Primitive
{
 public:
  Stairs(const Corners& corners, Direction direction, std::int32_t steps)
      : m_corners(corners), m_direction(direction), m_steps(steps)
  {
  }

  static std::unique_ptr<Primitive> read(params::StrictSection& section)
  {
    const Corners corners = readCorners(section);
    const Direction direction = readDirection(section);
    require(section, "steps", "the number of steps");
    std::int32_t steps = 0;
    section.read("steps", steps);
    if (steps < 1 || steps > kMostSteps) section.fail("steps", "within 1 and 10000");
    return std::make_unique<Stairs>(corners, direction, steps);
  }

  Footprint footprint() const override
  {
    return {m_corners.min.x, m_corners.min.y, m_corners.max.x, m_corners.max.y};
  }

  void appendMesh(Mesh& mesh) const override
  {
    MeshBuilder build(mesh);
    const auto &min = m_corners.min, &max = m_corners.max;
    for (std::int32_t step = 0; step < m_steps; ++step)
    {
      const auto corner = [&](std::int32_t edge, bool right, std::int32_t level)
      {
        const double along = place(edge), across = m_direction.alongY ? (right ? max.x : min.x)
                                                                      : (right ? max.y : min.y);
        return m_direction.alongY ? build.vertex(across, along, height(level))
                                  : build.vertex(along, across, height(level));
      };
      const auto face = [&](std::int32_t e0, std::int32_t l0, std::int32_t e1, std::int32_t l1)
      {
        build.quad(corner(e0, false, l0), corner(e0, true, l0), corner(e1, true, l1),
                   corner(e1, false, l1));
      };
      face(step, step, step, step + 1);          // riser
      face(step, step + 1, step + 1, step + 1);  // tread
      for (const bool right : {false, true})
        build.quad(corner(step, right, 0), corner(step + 1, right, 0),
                   corner(step + 1, right, step + 1), corner(step, right, step + 1));
      if (step > 0) continue;
      face(0, 0, m_steps, 0);              // bottom
      face(m_steps, 0, m_steps, m_steps);  // back
    }
  }

  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    const auto& [min, max] = m_corners;
    if (x < min.x || x > max.x || y < min.y || y > max.y) return;
    const double length = m_direction.alongY ? max.y - min.y : max.x - min.x;
    const double along = m_direction.alongY ? y - min.y : x - min.x;
    const double share = (m_direction.backwards ? length - along : along) / length;
    const auto step = static_cast<std::int32_t>(std::floor(share * m_steps));
    solids.push_back({min.z, height(std::clamp(step, 0, m_steps - 1) + 1), 0});
  }

 private:
  double height(std::int32_t level) const
  {
    const auto& [min, max] = m_corners;
    return level == m_steps ? max.z : min.z + (max.z - min.z) * level / m_steps;
  }
  /** Of a riser on the stairs' axis, counted from their foot [m]. */
  double place(std::int32_t edge) const
  {
    const double low = m_direction.alongY ? m_corners.min.y : m_corners.min.x;
    const double high = m_direction.alongY ? m_corners.max.y : m_corners.max.x;
    return low + (high - low) * (m_direction.backwards ? m_steps - edge : edge) / m_steps;
  }

  Corners m_corners;
  Direction m_direction;
  std::int32_t m_steps;
};

const PrimitiveKind kKind("stairs", Stairs::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
