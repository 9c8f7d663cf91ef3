#include <algorithm>

#include "../Furniture.h"

namespace mrpt_mapconv::sim
{
namespace
{
/** A top on four legs. min, max: corners of the top, x y [m]; height: of its upper face above the
 * floor [m], default 0.74; thickness: of the top [m], default 0.03; leg: side of the square legs in
 * its corners [m], default 0.05; base, yaw: see Furniture. */
class Table : public Furniture
{
 public:
  Table(params::StrictSection& section, const Outline& outline)
      : Furniture(section, outline.middle())
  {
    const double height = readPositive(section, "height", 0.74);
    const double thickness = readPositive(section, "thickness", 0.03);
    const double leg = readPositive(section, "leg", 0.05);
    const auto size = outline.size();
    if (!(thickness < height)) section.fail("thickness", "below the height");
    if (!(2 * leg <= std::min(size.x, size.y))) section.fail("leg", "at most half of each side");
    addLegs(size, leg, height - thickness);
    const double x = size.x / 2, y = size.y / 2;
    add({{-x, -y, height - thickness}, {x, y, height}});
  }

  static std::unique_ptr<Primitive> read(params::StrictSection& section)
  {
    return std::make_unique<Table>(section, readOutline(section));
  }
};

const PrimitiveKind kKind("table", Table::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
