#include "CeilingCheck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "BitRow.h"
#include "LevelPlane.h"
#include "LineFan.h"

namespace mrpt_mapconv::scan
{
namespace
{
constexpr std::size_t kSectors = 256;
constexpr std::size_t kFewest = 16;  // sectors with structure that tell anything
constexpr int kFits = 6;
constexpr double kSpread = 0.5;  // of a ceiling's points in a sector, at least [m]
constexpr double kBehind = 0.3;  // of the nearest structure point [m]
constexpr double kNone = std::numeric_limits<double>::infinity();

std::size_t sectorOf(double x, double y)
{
  return static_cast<std::size_t>(diamondAngleOf(x, y) * (kSectors / 4)) % kSectors;
}

struct Sector
{
  const StructurePoint* nearest = nullptr;
  double nearestSq = kNone;                      // its range [m²]
  double leastRangeSq = kNone, mostRangeSq = 0;  // of the points in the plane [m²]
  bool isLevel = false;                          // its nearest point is in the plane

  double spread() const { return std::sqrt(mostRangeSq) - std::sqrt(leastRangeSq); }
};

/** Sectors around the sensor, and the plane through their nearest structure points. */
class CeilingSearch
{
 public:
  CeilingSearch(const Slices& slices, double band) : m_slices(slices), m_band(band)
  {
    for (const StructurePoint& point : slices.structure) add(point);
  }
  /** False if too few of the points are in any. */
  bool findPlane();
  /** True if the plane is no wall's. */
  bool isCeiling(double sliceEnd);
  bool cutsObjects(const SensorPlace& place, const CellBits& objects) const;
  double height() const;

 private:
  void add(const StructurePoint& point);
  double abovePlane(const StructurePoint& point) const
  {
    return point.height - m_plane.at(point.x, point.y);
  }
  bool isCut(double x, double y) const;

  const Slices& m_slices;
  const double m_band;  // [m]
  std::array<Sector, kSectors> m_sectors;
  LevelPlane m_plane;
  std::size_t m_withStructure = 0, m_level = 0;  // sectors
};

void CeilingSearch::add(const StructurePoint& point)
{
  const double rangeSq = point.x * point.x + point.y * point.y;
  if (!(rangeSq > 0)) return;  // right above: in no sector
  Sector& sector = m_sectors[sectorOf(point.x, point.y)];
  if (rangeSq >= sector.nearestSq) return;
  sector.nearestSq = rangeSq;
  sector.nearest = &point;
}

/** Far points weigh less, or far walls would be levers. Walls pull the first plane down; the next
 * ones leave out what is below the one before, since above a ceiling there is nothing. */
bool CeilingSearch::findPlane()
{
  m_withStructure = static_cast<std::size_t>(std::count_if(
      m_sectors.begin(), m_sectors.end(), [](const Sector& s) { return s.nearest != nullptr; }));
  if (m_withStructure < kFewest) return false;
  for (int i = 0; i < kFits; ++i)
  {
    LevelPlaneFit fit;
    for (const Sector& s : m_sectors)
      if (s.nearest && (i == 0 || abovePlane(*s.nearest) >= -m_band))
        fit.add(s.nearest->x, s.nearest->y, s.nearest->height, 1 / (1 + s.nearestSq));
    m_plane = fit.plane();
  }
  for (Sector& s : m_sectors)
  {
    s.isLevel = s.nearest && std::abs(abovePlane(*s.nearest)) <= m_band;
    m_level += s.isLevel;
  }
  return 3 * m_level >= m_withStructure;
}

/** Walls fill the slice up to its end, and a sector meets them at one range. */
bool CeilingSearch::isCeiling(double sliceEnd)
{
  std::size_t inPlane = 0, above = 0;
  for (const StructurePoint& point : m_slices.structure)
  {
    const double up = abovePlane(point), rangeSq = point.x * point.x + point.y * point.y;
    above += up > m_band;
    if (std::abs(up) > m_band || !(rangeSq > 0)) continue;
    ++inPlane;
    Sector& sector = m_sectors[sectorOf(point.x, point.y)];
    sector.leastRangeSq = std::min(sector.leastRangeSq, rangeSq);
    sector.mostRangeSq = std::max(sector.mostRangeSq, rangeSq);
  }
  const auto goingOn = static_cast<std::size_t>(
      std::count_if(m_sectors.begin(), m_sectors.end(),
                    [](const Sector& s) { return s.isLevel && s.spread() > kSpread; }));
  const bool goesOn = 5 * m_level >= 3 * m_withStructure && 2 * goingOn > m_level;
  const bool hasRoomAbove = height() < sliceEnd - 2 * m_band;
  return (goesOn && 4 * above < inPlane) || (hasRoomAbove && 100 * above <= inPlane);
}

bool CeilingSearch::isCut(double x, double y) const
{
  if (x == 0 && y == 0) return false;
  return std::hypot(x, y) > std::sqrt(m_sectors[sectorOf(x, y)].nearestSq) + kBehind;
}

bool CeilingSearch::cutsObjects(const SensorPlace& place, const CellBits& objects) const
{
  const std::int32_t half = m_slices.reach;
  std::size_t all = 0, cut = 0;
  for (std::int32_t iy = 0; iy <= 2 * half; ++iy)
    for (std::int32_t word = 0; word < static_cast<std::int32_t>(objects.wordsPerRow()); ++word)
      forEachBit(objects.row(iy)[word], word,
                 [&](std::int32_t ix)
                 {
                   ++all;
                   cut += isCut((ix - half + 0.5 - place.fx) * place.resolution,
                                (iy - half + 0.5 - place.fy) * place.resolution);
                 });
  return all > 0 && 10 * cut >= all;
}

/** Mean of the plane's heights at the nearest points that are in it [m]. */
double CeilingSearch::height() const
{
  double sum = 0;
  for (const Sector& s : m_sectors)
    if (s.isLevel) sum += m_plane.at(s.nearest->x, s.nearest->y);
  return sum / static_cast<double>(m_level);
}
}  // namespace

std::optional<double> ceilingIn(const Slices& slices, const SensorPlace& place,
                                const CellBits& objects, const ProfileParams& params)
{
  constexpr double kMostBand = 0.05;  // [m]
  const double sliceHeight = params.structureMaxZ - params.structureMinZ;
  CeilingSearch search(slices, std::min(kMostBand, sliceHeight / 6));
  // the cheap signs first
  if (search.findPlane() && search.isCeiling(params.structureMaxZ) &&
      search.cutsObjects(place, objects))
    return search.height();
  return std::nullopt;
}

}  // namespace mrpt_mapconv::scan
