#include "../Furniture.h"

namespace mrpt_mapconv::sim
{
namespace
{
/** A square seat on four legs, with a back; who sits on it looks along its x axis. centre: of the
 * seat, x y [m]; size: side of the seat [m], default 0.44; seat: its height above the floor [m],
 * default 0.45; height: of the back's upper edge [m], default 0.9; leg: side of the square legs
 * [m], default 0.025; base, yaw: see Furniture. */
class Chair : public Furniture
{
 public:
  explicit Chair(params::StrictSection& section)
      : Furniture(section, readPoint2D(section, "centre"))
  {
    const double size = readPositive(section, "size", 0.44);
    const double seat = readPositive(section, "seat", 0.45);
    const double height = readPositive(section, "height", 0.9);
    const double leg = readPositive(section, "leg", 0.025);
    if (!(size >= 2 * kBack)) section.fail("size", "at least 0.06");
    if (!(seat > kSeat)) section.fail("seat", "above 0.04, the seat's thickness");
    if (!(height > seat)) section.fail("height", "above the seat");
    if (!(2 * leg <= size)) section.fail("leg", "at most half of the size");
    addLegs({size, size}, leg, seat - kSeat);
    const double half = size / 2;
    add({{-half, -half, seat - kSeat}, {half, half, seat}});
    add({{-half, -half, seat}, {kBack - half, half, height}});
  }

  static std::unique_ptr<Primitive> read(params::StrictSection& section)
  {
    return std::make_unique<Chair>(section);
  }

 private:
  static constexpr double kSeat = 0.04, kBack = 0.03;  //!< thickness [m]
};

const PrimitiveKind kKind("chair", Chair::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
