#include <cmath>

#include "../Block.h"
#include "../SectionKeys.h"

namespace mrpt_mapconv::sim
{
namespace
{
/** A thin upright wall, of glass for example. from, to: ends of its middle line, x y [m]; bottom,
 * top [m]; thickness [m], default 0.01; transparency: share of the rays that pass the whole pane,
 * both faces, 0 … 1, default 0; the others return from the face that they meet first. */
class Pane : public Primitive
{
 public:
  Pane(const Block& block, double transparency) : m_block(block), m_transparency(transparency) {}

  static std::unique_ptr<Primitive> read(maps::StrictSection& section)
  {
    const auto from = readPoint2D(section, "from"), to = readPoint2D(section, "to");
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0)) section.fail("to", "another place than from");
    const double bottom = readNumber(section, "bottom"), top = readNumber(section, "top");
    if (!(bottom < top)) section.fail("top", "above bottom");
    double thickness = 0.01, transparency = 0;
    if (section.has("thickness")) thickness = readPositive(section, "thickness");
    section.read("transparency", transparency);
    if (!(transparency >= 0 && transparency <= 1)) section.fail("transparency", "within 0 and 1");
    const Block block({(from.x + to.x) / 2, (from.y + to.y) / 2, (bottom + top) / 2},
                      {length, thickness, top - bottom}, std::atan2(to.y - from.y, to.x - from.x));
    return std::make_unique<Pane>(block, transparency);
  }

  Footprint footprint() const override { return m_block.footprint(); }
  void appendMesh(Mesh& mesh) const override { m_block.appendMesh(mesh); }
  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    m_block.appendSolids(x, y, solids);
  }
  double transparency() const override { return m_transparency; }

 private:
  Block m_block;
  double m_transparency;
};

const PrimitiveKind kKind("pane", Pane::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
