#include "CeilingCheck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "LineFan.h"

namespace mrpt_mapconv::scan
{
namespace
{
constexpr std::size_t kSectors = 64;
constexpr double kBehind = 0.3;  // of the nearest structure point [m]
constexpr double kNone = std::numeric_limits<double>::infinity();

std::size_t sectorOf(double x, double y)
{
  return static_cast<std::size_t>(diamondAngleOf(x, y) * (kSectors / 4)) % kSectors;
}

struct Sector
{
  double nearestSq = kNone;  // of the structure points [m²]
  double height = kNone;     // of that point
  double farthestSq = -1;    // of the objects [m²]
};
using Sectors = std::array<Sector, kSectors>;

void addStructure(const Slices& slices, Sectors& sectors)
{
  for (const StructurePoint& point : slices.structure)
  {
    const double rangeSq = point.x * point.x + point.y * point.y;
    if (!(rangeSq > 0)) continue;  // right above: in no sector
    Sector& sector = sectors[sectorOf(point.x, point.y)];
    if (rangeSq < sector.nearestSq) sector = {rangeSq, point.height, -1};
  }
}

void addObjects(const Slices& slices, const SensorPlace& place, Sectors& sectors)
{
  for (const CellOffset& cell : slices.object)
  {
    const double x = (cell.x + 0.5 - place.fx) * place.resolution,
                 y = (cell.y + 0.5 - place.fy) * place.resolution;
    if (x == 0 && y == 0) continue;
    Sector& sector = sectors[sectorOf(x, y)];
    sector.farthestSq = std::max(sector.farthestSq, x * x + y * y);
  }
}

/** Of the sectors that hold a structure point. */
std::optional<double> medianHeight(const Sectors& sectors)
{
  std::array<double, kSectors> heights{};
  auto end = heights.begin();
  for (const Sector& sector : sectors)
    if (sector.height < kNone) *end++ = sector.height;
  if (end == heights.begin()) return std::nullopt;
  const auto middle = heights.begin() + (end - heights.begin()) / 2;
  std::nth_element(heights.begin(), middle, end);
  return *middle;
}
}  // namespace

std::optional<double> ceilingIn(const Slices& slices, const SensorPlace& place, double sliceHeight)
{
  constexpr std::ptrdiff_t kFewest = 8;  // sectors that tell anything
  Sectors sectors;
  addStructure(slices, sectors);
  const auto height = medianHeight(sectors);
  if (!height) return std::nullopt;
  const double band = std::min(0.05, sliceHeight / 4);
  const auto isLevel = [&](const Sector& s) { return std::abs(s.height - *height) <= band; };
  const auto hasObject = [](const Sector& s) { return s.farthestSq >= 0; };
  const auto isShut = [&](const Sector& s)
  {
    return hasObject(s) && isLevel(s) && std::sqrt(s.farthestSq) > std::sqrt(s.nearestSq) + kBehind;
  };
  // The objects are many, so they are only looked at if the rest is as under a ceiling.
  if (std::count_if(sectors.begin(), sectors.end(), isLevel) < kFewest / 2) return std::nullopt;
  addObjects(slices, place, sectors);
  const auto withObject = std::count_if(sectors.begin(), sectors.end(), hasObject);
  const auto shut = std::count_if(sectors.begin(), sectors.end(), isShut);
  return withObject >= kFewest && 2 * shut > withObject ? height : std::nullopt;
}

}  // namespace mrpt_mapconv::scan
