#include "RandomScan.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mrpt_mapconv::test
{
using mrpt::math::TPoint3D;
using mrpt::math::TPoint3Df;
using scan::ProfileParams;
using scan::Viewpoint;

namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr double kResolutions[] = {0.05, 0.1, 0.25};
constexpr double kClear = 1e-5;  // [m], [rad]: points nearer to a limit are left out

std::int32_t randomSectors(Rng& rng, Lines lines)
{
  switch (lines)
  {
    case Lines::Default:
      return 0;
    case Lines::Few:
      return pick(rng, 1, 8);
    case Lines::Odd:
      return 4 * pick(rng, 2, 30) + pick(rng, 1, 3);
    case Lines::Fours:
      return 4 * pick(rng, 1, 50);
    default:
      return pick(rng, 300, 1000);
  }
}

double highestTop(const ProfileParams& params)
{
  return params.reflectionFilter ? std::max(params.objectMaxZ, params.structureMaxZ)
                                 : params.objectMaxZ;
}

/** Heights above the base that points of one kind have. */
struct Heights
{
  double min, max;
};

/** Draws points cell by cell and keeps those that no rounding can move. */
class PointCloud
{
 public:
  PointCloud(Rng& rng, const Viewpoint& view, double resolution, const ProfileParams& params)
      : m_rng(rng), m_view(view), m_resolution(resolution), m_params(params)
  {
  }

  void add(int kx, int ky, const Heights& heights)
  {
    const double x = (kx + uniform(m_rng, 0.03, 0.97)) * m_resolution;
    const double y = (ky + uniform(m_rng, 0.03, 0.97)) * m_resolution;
    const double z = m_view.baseZ + uniform(m_rng, heights.min, heights.max);
    const TPoint3Df point(m_view.sensorPose.inverseComposePoint(TPoint3D(x, y, z)));
    if (isClear(m_view.sensorPose.composePoint(TPoint3D(point)))) m_points.push_back(point);
  }
  std::vector<TPoint3Df> take() { return std::move(m_points); }

 private:
  static bool isFar(double value, double limit) { return !(std::abs(value - limit) < kClear); }

  bool isClear(const TPoint3D& inMap) const
  {
    const double z = inMap.z - m_view.baseZ;
    const double dx = inMap.x - m_view.sensorPose.x(), dy = inMap.y - m_view.sensorPose.y();
    const double range = std::hypot(dx, dy);
    return isFar(z, m_params.objectMinZ) && isFar(z, m_params.objectMaxZ) &&
           isFar(z, m_params.structureMinZ) && isFar(z, m_params.structureMaxZ) &&
           isFar(range, m_params.minRange) && isFar(range, m_params.maxRange) && isFar(range, 0) &&
           isClearOfGaps(std::atan2(dy, dx));
  }

  /** Whether no line is about structureGap from an azimuth. */
  bool isClearOfGaps(double azimuth) const
  {
    const double gap = oracle::ScanOracle::structureGap(m_view, m_params);
    const double step = 2 * kPi / oracle::ScanOracle::lineCount(m_resolution, m_params);
    return isFar(std::remainder(azimuth + gap, step), 0) &&
           isFar(std::remainder(azimuth - gap, step), 0);
  }

  Rng& m_rng;
  const Viewpoint& m_view;
  double m_resolution;
  const ProfileParams& m_params;
  std::vector<TPoint3Df> m_points;
};

/** A straight row of cells. */
struct Row
{
  int x, y, dx, dy, length;
};

Row randomRow(Rng& rng, int cx, int cy, int radius)
{
  return {cx + pick(rng, -radius, radius), cy + pick(rng, -radius, radius), pick(rng, -1, 1),
          pick(rng, -1, 1), pick(rng, 1, radius)};
}

/** Cells in a row, some left out, each with up to `most` points. */
void addRow(Rng& rng, const Row& row, const Heights& heights, int percent, int most,
            PointCloud& cloud)
{
  for (int i = 0; i < row.length; ++i)
    if (chance(rng, percent))
      for (int n = pick(rng, 1, most); n > 0; --n)
        cloud.add(row.x + i * row.dx, row.y + i * row.dy, heights);
}
}  // namespace

ProfileParams randomParams(Rng& rng, double resolution, scan::Model model, bool filter, Lines lines)
{
  ProfileParams params;
  params.model = model;
  params.reflectionFilter = filter;
  params.objectMinZ = uniform(rng, -0.1, 0.3);
  params.objectMaxZ = uniform(rng, 1, 2);
  params.structureMinZ = uniform(rng, 1.8, 2.2);  // sometimes below the top of the objects
  params.structureMaxZ = uniform(rng, 2.3, 2.6);
  params.minRange = chance(rng, 30) ? 0 : uniform(rng, 0.5, 3) * resolution;
  params.maxRange = uniform(rng, 4, 14) * resolution;
  params.sectors = randomSectors(rng, lines);
  if (chance(rng, 60)) params.structureGap = chance(rng, 20) ? 0 : uniform(rng, 0.001, 0.4);
  if (chance(rng, 60))
    params.structureTolerance = chance(rng, 20) ? 0 : uniform(rng, 0.1, 5) * resolution;
  return params;
}

Viewpoint randomViewpoint(Rng& rng, double resolution, const ProfileParams& params)
{
  Viewpoint view;
  view.baseZ = chance(rng, 30) ? 0 : uniform(rng, -3, 3);
  if (chance(rng, 50)) view.azimuthStep = uniform(rng, 0.001, 0.3);
  const double x = (pick(rng, -60, 60) + uniform(rng, 0.03, 0.97)) * resolution;
  const double y = (pick(rng, -60, 60) + uniform(rng, 0.03, 0.97)) * resolution;
  const double z = view.baseZ + uniform(rng, params.objectMinZ + 0.01, highestTop(params) - 0.01);
  const double yaw = uniform(rng, -kPi, kPi), tilt = chance(rng, 30) ? 0 : uniform(rng, 0, 1.2);
  view.sensorPose =
      mrpt::poses::CPose3D(x, y, z, yaw, uniform(rng, -tilt, tilt), uniform(rng, -tilt, tilt));
  return view;
}

std::vector<TPoint3Df> randomPoints(Rng& rng, const Viewpoint& view, double resolution,
                                    const ProfileParams& params, int radius)
{
  const Heights object{params.objectMinZ, params.objectMaxZ};
  const Heights structure{params.structureMinZ, params.structureMaxZ};
  const Heights any{params.objectMinZ - 0.5, params.structureMaxZ + 0.5};
  const int cx = static_cast<int>(std::floor(view.sensorPose.x() / resolution));
  const int cy = static_cast<int>(std::floor(view.sensorPose.y() / resolution));
  PointCloud cloud(rng, view, resolution, params);
  for (int i = pick(rng, 0, 8); i > 0; --i)  // walls, many with holes
  {
    const Row row = randomRow(rng, cx, cy, radius);
    const int percent = pick(rng, 40, 100);
    addRow(rng, row, structure, percent, 2, cloud);
    if (chance(rng, 70)) addRow(rng, row, object, percent, 2, cloud);
  }
  for (int i = pick(rng, 1, 12); i > 0; --i)  // objects, before walls and behind
    addRow(rng, randomRow(rng, cx, cy, radius), object, pick(rng, 20, 100), 3, cloud);
  for (int i = pick(rng, 0, 3 * radius); i > 0; --i)  // floor, ceiling and whatever
    addRow(rng, randomRow(rng, cx, cy, radius), any, 10, 1, cloud);
  return cloud.take();
}

RandomScan randomScan(Rng& rng, scan::Model model, bool filter, Lines lines)
{
  RandomScan scan;
  scan.resolution = kResolutions[pick(rng, 0, 2)];
  scan.params = randomParams(rng, scan.resolution, model, filter, lines);
  scan.view = randomViewpoint(rng, scan.resolution, scan.params);
  scan.points = randomPoints(rng, scan.view, scan.resolution, scan.params, pick(rng, 2, 12));
  return scan;
}

std::string RandomScan::text() const
{
  std::ostringstream out;
  out.precision(17);
  out << points.size() << " points, resolution " << resolution << ", sensor "
      << view.sensorPose.asString() << ", baseZ " << view.baseZ << ", azimuthStep "
      << view.azimuthStep << ", model "
      << (params.model == scan::Model::WholeShape ? "wholeShape" : "closestPoint") << ", object ["
      << params.objectMinZ << ", " << params.objectMaxZ << "], filter " << params.reflectionFilter
      << ", structure [" << params.structureMinZ << ", " << params.structureMaxZ << "], range ["
      << params.minRange << ", " << params.maxRange << "], sectors " << params.sectors
      << ", structureGap " << params.structureGap << ", structureTolerance "
      << params.structureTolerance;
  return out.str();
}

oracle::CellKeys keysOf(const scan::CellBits& cells)
{
  oracle::CellKeys keys;
  const grid::GridFrame& frame = cells.frame();
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
      if (cells.test(ix, iy)) keys.emplace(frame.x0 + ix, frame.y0 + iy);
  return keys;
}

}  // namespace mrpt_mapconv::test
