#include "../Block.h"
#include "../SectionKeys.h"

namespace mrpt_mapconv::sim
{
namespace
{
constexpr double kDegree = 3.14159265358979323846 / 180;

/** min, max: corners x y z [m]; yaw: turned about its centre [°], default 0; mirror: share of the
 * rays that are reflected at a right angle, 0 … 1, default 0. */
class Box : public Primitive
{
 public:
  Box(const Block& block, double mirror) : m_block(block), m_mirror(mirror) {}

  static std::unique_ptr<Primitive> read(params::StrictSection& section)
  {
    const Corners corners = readCorners(section);
    double yaw = 0;
    section.read("yaw", yaw);
    return std::make_unique<Box>(Block(corners.centre(), corners.size(), yaw * kDegree),
                                 readShare(section, "mirror"));
  }

  Footprint footprint() const override { return m_block.footprint(); }
  void appendMesh(Mesh& mesh) const override { m_block.appendMesh(mesh); }
  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    m_block.appendSolids(x, y, solids);
  }
  double mirror() const override { return m_mirror; }

 private:
  Block m_block;
  double m_mirror;
};

const PrimitiveKind kKind("box", Box::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
