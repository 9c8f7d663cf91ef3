#include "PlaneSet.h"

#include <array>

namespace mrpt_mapconv::terrain
{
namespace
{
struct Step
{
  std::int32_t x, y;
};
/** Around a cell, each beside the next. */
constexpr std::array<Step, 8> kRing{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/** For each set of cells of the ring: whether those beside the cell (the even ones) are connected
 * within it. */
constexpr std::array<bool, 256> connectedRings()
{
  std::array<bool, 256> table{};
  for (unsigned ring = 0; ring < 256; ++ring)
  {
    int parts = 0;
    for (unsigned i = 0; i < 8; i += 2)
    {
      if (!(ring >> i & 1u)) continue;
      // a part is counted at that of its cells beside the middle which no other one comes before
      const unsigned before = (i + 7) % 8, previous = (i + 6) % 8;
      parts += (ring >> before & 1u) && (ring >> previous & 1u) ? 0 : 1;
    }
    table[ring] = parts <= 1;
  }
  return table;
}
constexpr auto kConnected = connectedRings();
}  // namespace

bool isDispensable(const CellRef& cell)
{
  const std::int32_t id = cell.tile->plane[cell.index()];
  unsigned ring = 0;
  for (std::size_t i = 0; i < kRing.size(); ++i)
  {
    const CellRef other = cellAt(*cell.tile, cell.ix + kRing[i].x, cell.iy + kRing[i].y);
    if (other && other.tile->plane[other.index()] == id) ring |= 1u << i;
  }
  return kConnected[ring];
}

}  // namespace mrpt_mapconv::terrain
