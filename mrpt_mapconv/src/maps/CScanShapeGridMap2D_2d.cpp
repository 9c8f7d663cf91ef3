#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>
#include <mrpt_mapconv/observation/FinitePose.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/PoseTrack.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "../observation/MaxRange.h"

// How 2D scans get into a CScanShapeGridMap2D: as the base class inserts them, but in a grid that
// has room, since its own growth knows no limit and with some resolutions moves the cells a little,
// and only such as the base class can take: it crashes on some and believes in NaN ranges.

namespace mrpt_mapconv
{
using Base = mrpt::maps::COccupancyGridMap2D;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose3D;

namespace
{
/** A length that rays can be cut to, and a step that gets to the end of a scan. */
void checkOptions(const Base::TInsertionOptions& options)
{
  const float most = options.maxDistanceInsertion;
  params::require(std::isfinite(most) && most > 0, "maxDistanceInsertion", most, "a range > 0 m");
  params::require(options.decimation > 0, "decimation", options.decimation, "at least 1");
}

/** Why a scan as a whole is of no use; null if it is. */
const char* whyRefused(const CObservation2DRangeScan& scan, const CPose3D& sensor,
                       const Base::TInsertionOptions& options)
{
  constexpr float fullTurn = 6.2832f;         // 2 pi, rounded up
  constexpr double altitudeTolerance = 1e-3;  // MRPT's [m]
  if (scan.getScanSize() == 0) return "it has no range";
  if (!(scan.aperture >= 0 && scan.aperture <= fullTurn))
    return "its aperture is not an angle from 0 to 2 pi";
  if (!observation::isFinite(sensor)) return "its pose is not finite";
  if (!scan.isPlanarScan(options.horizontalTolerance))
    return "its sensor is tilted by more than horizontalTolerance";
  if (options.useMapAltitude && std::abs(options.mapAltitude - sensor.z()) > altitudeTolerance)
    return "its sensor is not at mapAltitude";
  return nullptr;
}

bool isBadRay(const CObservation2DRangeScan& scan, std::size_t i)
{
  return scan.getScanRangeValidity(i) &&
         !(std::isfinite(scan.getScanRange(i)) && scan.getScanRange(i) >= 0);
}

/** The scan without its bad rays; nothing if it has none. */
std::optional<CObservation2DRangeScan> withoutBadRays(const CObservation2DRangeScan& scan)
{
  std::optional<CObservation2DRangeScan> mended;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i)
  {
    if (!isBadRay(scan, i)) continue;
    if (!mended) mended = scan;
    mended->setScanRangeValidity(i, false);
  }
  return mended;
}

/** Has a scan's ranges from its maxRange on, which are no returns, end before an obstacle, for as
 * long as this lives: the base class only knows a maxDistanceInsertion. */
class WithinMaxRange
{
 public:
  WithinMaxRange(Base::TInsertionOptions& options, const CObservation2DRangeScan& scan)
      : m_distance(options.maxDistanceInsertion), m_set(options.maxDistanceInsertion)
  {
    const observation::MaxRange most(scan.maxRange);
    if (most.isSet()) m_distance = std::min(m_distance, static_cast<float>(most.from()));
  }
  ~WithinMaxRange() { m_distance = m_set; }
  WithinMaxRange(const WithinMaxRange&) = delete;
  WithinMaxRange& operator=(const WithinMaxRange&) = delete;

 private:
  float& m_distance;
  float m_set;
};

/** Where the rays that are inserted end; also the sensor is inside. */
struct RayBox
{
  double xLow, xHigh, yLow, yHigh;  //!< [m]
  bool hasValid = false;            //!< whether one of the rays is a valid one

  RayBox(double x, double y) : xLow(x), xHigh(x), yLow(y), yHigh(y) {}
  void add(double x, double y)
  {
    xLow = std::min(xLow, x);
    xHigh = std::max(xHigh, x);
    yLow = std::min(yLow, y);
    yHigh = std::max(yHigh, y);
  }
};

/** Lays the rays as the base class does, in its floats. */
RayBox rayBoxOf(const CObservation2DRangeScan& scan, const CPose3D& sensor,
                const Base::TInsertionOptions& options)
{
  const std::size_t step = options.decimation;
  const std::size_t n = scan.getScanSize();
  const bool upsideDown = sensor.getRotationMatrix()(2, 2) < 0;
  const float turn = scan.rightToLeft != upsideDown ? 1.0f : -1.0f;
  const float perRay = turn * scan.aperture / static_cast<float>(n);
  const float widening =
      options.wideningBeamsWithDistance ? 0.5f * scan.aperture / static_cast<float>(n) : 0;
  float angle = static_cast<float>(sensor.yaw() - 0.5 * static_cast<double>(turn * scan.aperture));
  float lastValid = options.maxDistanceInsertion;
  RayBox box(sensor.x(), sensor.y());
  for (std::size_t i = 0; i < n; i += step, angle += static_cast<float>(step) * perRay)
  {
    const bool valid = scan.getScanRangeValidity(i);
    if (!valid && !options.considerInvalidRangesAsFreeSpace) continue;
    if (valid) lastValid = scan.getScanRange(i);
    box.hasValid |= valid;
    const float length = std::min(options.maxDistanceInsertion, valid ? lastValid : lastValid / 2);
    for (const float a : {angle - widening, angle, angle + widening})
      box.add(sensor.x() + static_cast<double>(length * std::cos(a)),
              sensor.y() + static_cast<double>(length * std::sin(a)));
  }
  return box;
}

/** The cells that the base class wants to be there; as many as keys can name. */
grid::GridFrame frameFor(const RayBox& box, double resolution)
{
  constexpr double mrptsMargin = 16;  // cells; with fewer around the rays, the base class grows
  const auto key = [resolution](double metres, double margin)
  {
    constexpr double farthest = 1e9;
    const double cells = std::floor(metres / resolution + margin);
    return static_cast<std::int32_t>(std::clamp(cells, -farthest, farthest));
  };
  grid::GridFrame frame{resolution, key(box.xLow, -mrptsMargin), key(box.yLow, -mrptsMargin), 0, 0};
  frame.width = key(box.xHigh, mrptsMargin) - frame.x0 + 1;
  frame.height = key(box.yHigh, mrptsMargin) - frame.y0 + 1;
  return frame;
}
}  // namespace

bool CScanShapeGridMap2D::insert2D(const CObservation2DRangeScan& scan, const CPose3D& robotPose)
{
  if (!scanInsertionOptions.insert2D) return m_log.ignore("it is a 2D scan, and insert2D = false");
  checkOptions(insertionOptions);
  const CPose3D sensor = robotPose + scan.sensorPose;
  if (const char* why = whyRefused(scan, sensor, insertionOptions)) return m_log.skip(scan, why);
  checkNear(sensor);
  const auto mended = withoutBadRays(scan);
  if (mended)
    m_log.warnings.warnOnceOf({"bad rays", scan.GetRuntimeClass()->className, scan.sensorLabel},
                              [&]
                              {
                                return "ranges of " + observation::nameOf(scan) +
                                       " that are NaN, infinite or negative count as invalid";
                              });
  const auto& usable = mended ? *mended : scan;
  const WithinMaxRange within(insertionOptions, usable);
  const RayBox box = rayBoxOf(usable, sensor, insertionOptions);
  if (!box.hasValid) return m_log.skip(scan, "it has no valid range");
  makeRoomFor(frameFor(box, frame().resolution));
  return Base::internal_insertObservation(usable, robotPose) ||
         m_log.skip(scan, "MRPT's own grid does not insert it");
}

}  // namespace mrpt_mapconv
