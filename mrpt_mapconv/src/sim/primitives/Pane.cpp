#include <cmath>

#include "../Block.h"
#include "../SectionKeys.h"

namespace mrpt_mapconv::sim
{
namespace
{
/** A thin upright wall, of glass for example. from, to: ends of its middle line, x y [m]; bottom,
 * top [m]; thickness [m], default 0.01; transparency: share of the rays that pass the whole pane,
 * both faces, 0 … 1, default 0; the others return from the face that they meet first; mirror: share
 * of the rays that are reflected instead, at a right angle, 0 … 1, default 0. */
class Pane : public Primitive
{
 public:
  Pane(const Block& block, double transparency, double mirror)
      : m_block(block), m_transparency(transparency), m_mirror(mirror)
  {
  }

  static std::unique_ptr<Primitive> read(params::StrictSection& section)
  {
    const auto from = readPoint2D(section, "from"), to = readPoint2D(section, "to");
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0)) section.fail("to", "another place than from");
    const double bottom = readNumber(section, "bottom"), top = readNumber(section, "top");
    if (!(bottom < top)) section.fail("top", "above bottom");
    const double thickness = readPositive(section, "thickness", 0.01);
    const double transparency = readShare(section, "transparency");
    const Block block({(from.x + to.x) / 2, (from.y + to.y) / 2, (bottom + top) / 2},
                      {length, thickness, top - bottom}, std::atan2(to.y - from.y, to.x - from.x));
    return std::make_unique<Pane>(block, transparency, readShare(section, "mirror"));
  }

  Footprint footprint() const override { return m_block.footprint(); }
  void appendMesh(Mesh& mesh) const override { m_block.appendMesh(mesh); }
  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    m_block.appendSolids(x, y, solids);
  }
  double transparency() const override { return m_transparency; }
  double mirror() const override { return m_mirror; }

 private:
  Block m_block;
  double m_transparency, m_mirror;
};

const PrimitiveKind kKind("pane", Pane::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
