#include "../Block.h"
#include "../SectionKeys.h"

namespace mrpt_mapconv::sim
{
namespace
{
constexpr double kDegree = 3.14159265358979323846 / 180;

/** min, max: corners x y z [m]; yaw: turned about its centre [°], default 0. */
class Box : public Primitive
{
 public:
  explicit Box(const Block& block) : m_block(block) {}

  static std::unique_ptr<Primitive> read(maps::StrictSection& section)
  {
    const Corners corners = readCorners(section);
    double yaw = 0;
    section.read("yaw", yaw);
    return std::make_unique<Box>(Block(corners.centre(), corners.size(), yaw * kDegree));
  }

  Footprint footprint() const override { return m_block.footprint(); }
  void appendMesh(Mesh& mesh) const override { m_block.appendMesh(mesh); }
  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    m_block.appendSolids(x, y, solids);
  }

 private:
  Block m_block;
};

const PrimitiveKind kKind("box", Box::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
