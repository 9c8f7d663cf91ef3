#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt_mapconv/observation/ExternalFiles.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/RotatingScanPoints.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "MaxRange.h"

namespace mrpt_mapconv::observation
{
using mrpt::math::TPoint3Df;
using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationRotatingScan;
using mrpt::obs::CObservationVelodyneScan;

namespace
{
using Points = std::vector<TPoint3Df>;

template <class Coordinates>
void zip(const Coordinates& x, const Coordinates& y, const Coordinates& z, Points& points)
{
  const std::size_t n = std::min({x.size(), y.size(), z.size()});
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) points.emplace_back(x[i], y[i], z[i]);
}

void zip(const mrpt::maps::CPointsMap& map, Points& points)
{
  zip(map.getPointsBufferRef_x(), map.getPointsBufferRef_y(), map.getPointsBufferRef_z(), points);
}

// readScan(): adds points and beams without return, and sets the step if it is known

void readScan(const CObservation2DRangeScan& scan, SensorPoints& out, SayOnceLog&)
{
  const std::size_t n = scan.getScanSize();
  const double turn = scan.rightToLeft ? 1 : -1;
  const MaxRange most(scan.maxRange);
  for (std::size_t i = 0; i < n; ++i)
  {
    if (!scan.getScanRangeValidity(i)) continue;
    // MRPT's getScanAngle() divides by zero for a single ray, which looks ahead.
    const double share = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.5;
    const double angle = turn * scan.aperture * (share - 0.5);
    const double measured = scan.getScanRange(i);
    const double range = most.cut(measured);
    auto& points = most.isReachedBy(measured) ? out.noReturns : out.points;
    points.emplace_back(static_cast<float>(range * std::cos(angle)),
                        static_cast<float>(range * std::sin(angle)), 0.0f);
  }
}

void readLoaded(const CObservation3DRangeScan& scan, Points& points)
{
  if (scan.hasPoints3D && !scan.points3D_x.empty())
    zip(scan.points3D_x, scan.points3D_y, scan.points3D_z, points);
}

/** Also if they have to be loaded, or made of the range image. */
void readPoints(const CObservation3DRangeScan& scan, Points& points)
{
  readLoaded(scan, points);
  if (!points.empty()) return;
  // Loading and unprojecting write into the observation.
  CObservation3DRangeScan copy = scan;
  // Copies of an image share their pixels: loading them would reach the original.
  copy.hasIntensityImage = copy.hasConfidenceImage = false;
  copy.intensityImage = mrpt::img::CImage();
  copy.confidenceImage = mrpt::img::CImage();
  loadExternal(copy);
  readLoaded(copy, points);
  if (!points.empty() || !copy.hasRangeImage || copy.rangeImage.size() == 0) return;
  mrpt::maps::CSimplePointsMap cloud;
  copy.unprojectInto(cloud);
  zip(cloud, points);
}

void readScan(const CObservation3DRangeScan& scan, SensorPoints& out, SayOnceLog&)
{
  if (scan.cameraParams.fx() > 0) out.azimuthStep = 1 / scan.cameraParams.fx();
  readPoints(scan, out.points);
  MaxRange(scan.maxRange, scan.rangeUnits)
      .sort(out, [depth = scan.range_is_depth](const TPoint3Df& point)
            { return depth ? point.x : point.norm(); });
}

void readScan(const CObservationPointCloud& scan, SensorPoints& out, SayOnceLog&)
{
  if (scan.pointcloud) return zip(*scan.pointcloud, out.points);
  if (!scan.isExternallyStored()) return;
  const CObservationPointCloud copy = scan;
  loadExternal(copy);
  if (copy.pointcloud) zip(*copy.pointcloud, out.points);
}

/** The model's name for the byte in a Velodyne's packet. */
std::string modelOf(const CObservationVelodyneScan& scan)
{
  switch (scan.scan_packets.front().velodyne_model_ID)
  {
    case 0x21:
      return "HDL-32E";
    case 0x22:
      return "VLP-16";
    default:
      return "model " + std::to_string(scan.scan_packets.front().velodyne_model_ID);
  }
}

/** How far a Velodyne turned between most blocks of its first packet [rad]. MRPT decodes one firing
 * of each block, so this is the step of its points as well. */
double stepOf(const CObservationVelodyneScan& scan)
{
  constexpr int fullTurn = 36000;  // [0.01°]
  const auto& blocks = scan.scan_packets.front().blocks;
  std::array<int, CObservationVelodyneScan::BLOCKS_PER_PACKET - 1> turns{};
  for (std::size_t i = 0; i < turns.size(); ++i)
    turns[i] = (blocks[i + 1].rotation() - blocks[i].rotation() + fullTurn) % fullTurn;
  // of two returns both blocks have the same azimuth
  const auto turned = std::remove(turns.begin(), turns.end(), 0);
  if (turned == turns.begin()) return 0;
  const auto middle = turns.begin() + (turned - turns.begin()) / 2;
  std::nth_element(turns.begin(), middle, turned);
  return mrpt::DEG2RAD(0.01 * *middle);
}

void readPoints(const CObservationVelodyneScan& scan, Points& points, SayOnceLog& warnings)
{
  if (scan.point_cloud.size() > 0)
    return zip(scan.point_cloud.x, scan.point_cloud.y, scan.point_cloud.z, points);
  if (scan.scan_packets.empty()) return;
  CObservationVelodyneScan copy = scan;
  copy.maxRange = std::numeric_limits<double>::max();  // what lies beyond would not be generated
  if (copy.calibration.empty()) copy.calibration = shippedCalibration(modelOf(scan));
  if (copy.calibration.empty())
    return warnings.warnOnce(
        "Velodyne scans without calibration are skipped: MRPT ships none for " + modelOf(scan));
  CObservationVelodyneScan::TGeneratePointCloudParameters params;
  params.minDistance = 0;  // the scan has its own minRange
  copy.generatePointCloud(params);
  zip(copy.point_cloud.x, copy.point_cloud.y, copy.point_cloud.z, points);
}

void readScan(const CObservationVelodyneScan& scan, SensorPoints& out, SayOnceLog& warnings)
{
  if (!scan.scan_packets.empty()) out.azimuthStep = stepOf(scan);
  readPoints(scan, out.points, warnings);
  MaxRange(scan.maxRange, CObservationVelodyneScan::DISTANCE_RESOLUTION)
      .sort(out, [](const TPoint3Df& point) { return point.norm(); });
}

void readScan(const CObservationRotatingScan& scan, SensorPoints& out, SayOnceLog& warnings)
{
  if (!rotatingScanPoints(scan, out))
    warnings.warnOnce("scans of the rotating scanner '" + scan.lidarModel +
                      "' are skipped: the elevation of its rows is not known");
}

bool isFinite(const TPoint3Df& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/** \return how many of the points were not finite */
std::size_t dropUnusable(Points& points)
{
  std::size_t notFinite = 0;
  const auto isBad = [&notFinite](const TPoint3Df& p)
  {
    if (isFinite(p)) return p.x == 0 && p.y == 0 && p.z == 0;
    ++notFinite;
    return true;
  };
  points.erase(std::remove_if(points.begin(), points.end(), isBad), points.end());
  return notFinite;
}

/** Reads the observation as a Scan, if it is one. */
template <class Scan>
bool readAs(const CObservation& obs, SensorPoints& out, SayOnceLog& warnings)
{
  const auto* scan = dynamic_cast<const Scan*>(&obs);
  if (!scan) return false;
  out.clear();
  try
  {
    readScan(*scan, out, warnings);
  }
  catch (const std::exception& e)
  {
    throw std::runtime_error(nameOf(obs) + " cannot be read: " + params::oneLine(e));
  }
  return true;
}

template <class... Scan>
bool isAny(const CObservation& obs)
{
  return (... || (dynamic_cast<const Scan*>(&obs) != nullptr));
}

}  // namespace

std::string nameOf(const CObservation& obs)
{
  const std::string name = obs.GetRuntimeClass()->className;
  return obs.sensorLabel.empty() ? name : name + " '" + obs.sensorLabel + "'";
}

bool is3DScan(const CObservation& obs)
{
  return isAny<CObservation3DRangeScan, CObservationPointCloud, CObservationVelodyneScan,
               CObservationRotatingScan>(obs);
}

bool isScan(const CObservation& obs)
{
  return isAny<CObservation2DRangeScan>(obs) || is3DScan(obs);
}

bool sensorPoints(const CObservation& obs, const mrpt::poses::CPose3D& robotPose, SensorPoints& out,
                  SayOnceLog* warnings)
{
  std::optional<SayOnceLog> silent;  // made only if needed: it takes memory
  SayOnceLog& to = warnings ? *warnings : silent.emplace();
  const bool read = readAs<CObservation2DRangeScan>(obs, out, to) ||
                    readAs<CObservation3DRangeScan>(obs, out, to) ||
                    readAs<CObservationPointCloud>(obs, out, to) ||
                    readAs<CObservationVelodyneScan>(obs, out, to) ||
                    readAs<CObservationRotatingScan>(obs, out, to);
  if (!read) return false;
  if (const auto n = dropUnusable(out.points) + dropUnusable(out.noReturns); n > 0)
    to.warnOnceOf({"not finite", obs.GetRuntimeClass()->className, obs.sensorLabel},
                  [&]
                  {
                    return std::to_string(n) +
                           " points with NaN or infinite coordinates dropped from " + nameOf(obs);
                  });
  mrpt::poses::CPose3D sensorOnRobot;
  obs.getSensorPose(sensorOnRobot);
  out.sensorPose = robotPose + sensorOnRobot;
  out.robotPose = robotPose;
  return true;
}

std::optional<SensorPoints> sensorPoints(const CObservation& obs,
                                         const mrpt::poses::CPose3D& robotPose,
                                         SayOnceLog* warnings)
{
  std::optional<SensorPoints> out(std::in_place);
  if (!sensorPoints(obs, robotPose, *out, warnings)) out.reset();
  return out;
}

}  // namespace mrpt_mapconv::observation
