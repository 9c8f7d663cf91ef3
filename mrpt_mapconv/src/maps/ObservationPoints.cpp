#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt_mapconv/maps/MrptError.h>
#include <mrpt_mapconv/maps/ObservationPoints.h>
#include <mrpt_mapconv/maps/RotatingScanPoints.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mrpt_mapconv::maps
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
Points zip(const Coordinates& x, const Coordinates& y, const Coordinates& z)
{
  Points points;
  const std::size_t n = std::min({x.size(), y.size(), z.size()});
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) points.emplace_back(x[i], y[i], z[i]);
  return points;
}

Points zip(const mrpt::maps::CPointsMap& map)
{
  return zip(map.getPointsBufferRef_x(), map.getPointsBufferRef_y(), map.getPointsBufferRef_z());
}

Points pointsOf(const CObservation2DRangeScan& scan, PointWarnings&)
{
  Points points;
  const std::size_t n = scan.getScanSize();
  const double turn = scan.rightToLeft ? 1 : -1;
  for (std::size_t i = 0; i < n; ++i)
  {
    if (!scan.getScanRangeValidity(i)) continue;
    // MRPT's getScanAngle() divides by zero for a single ray, which looks ahead.
    const double share = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.5;
    const double angle = turn * scan.aperture * (share - 0.5);
    const double range = scan.getScanRange(i);
    points.emplace_back(static_cast<float>(range * std::cos(angle)),
                        static_cast<float>(range * std::sin(angle)), 0.0f);
  }
  return points;
}

Points pointsOf(const CObservation3DRangeScan& scan, PointWarnings&)
{
  if (scan.hasPoints3D && !scan.points3D_x.empty())
    return zip(scan.points3D_x, scan.points3D_y, scan.points3D_z);
  // Loading and unprojecting write into the observation.
  CObservation3DRangeScan copy = scan;
  // Copies of an image share their pixels: loading them would reach the original.
  copy.hasIntensityImage = copy.hasConfidenceImage = false;
  copy.intensityImage = mrpt::img::CImage();
  copy.confidenceImage = mrpt::img::CImage();
  copy.load();
  if (copy.hasPoints3D && !copy.points3D_x.empty())
    return zip(copy.points3D_x, copy.points3D_y, copy.points3D_z);
  if (!copy.hasRangeImage || copy.rangeImage.size() == 0) return {};
  mrpt::maps::CSimplePointsMap cloud;
  copy.unprojectInto(cloud);
  return zip(cloud);
}

Points pointsOf(const CObservationPointCloud& scan, PointWarnings&)
{
  if (scan.pointcloud) return zip(*scan.pointcloud);
  const CObservationPointCloud copy = scan;
  copy.load();
  return copy.pointcloud ? zip(*copy.pointcloud) : Points();
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

Points pointsOf(const CObservationVelodyneScan& scan, PointWarnings& warnings)
{
  if (scan.point_cloud.size() > 0)
    return zip(scan.point_cloud.x, scan.point_cloud.y, scan.point_cloud.z);
  if (scan.scan_packets.empty()) return {};
  CObservationVelodyneScan copy = scan;
  if (copy.calibration.empty()) copy.calibration = shippedCalibration(modelOf(scan));
  if (copy.calibration.empty())
  {
    warnings.warnOnce("Velodyne scans without calibration are skipped: MRPT ships none for " +
                      modelOf(scan));
    return {};
  }
  CObservationVelodyneScan::TGeneratePointCloudParameters params;
  params.minDistance = 0;  // the scan has its own minRange
  copy.generatePointCloud(params);
  return zip(copy.point_cloud.x, copy.point_cloud.y, copy.point_cloud.z);
}

Points pointsOf(const CObservationRotatingScan& scan, PointWarnings& warnings)
{
  Points points;
  if (!rotatingScanPoints(scan, points))
    warnings.warnOnce("scans of the rotating scanner '" + scan.lidarModel +
                      "' are skipped: the elevation of its rows is not known");
  return points;
}

bool isFinite(const TPoint3Df& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

void dropUnusable(Points& points, const std::string& label, PointWarnings& warnings)
{
  const auto drop = [&points](const auto& isBad)
  {
    const auto end = std::remove_if(points.begin(), points.end(), isBad);
    const auto n = points.end() - end;
    points.erase(end, points.end());
    return n;
  };
  drop([](const TPoint3Df& p) { return p.x == 0 && p.y == 0 && p.z == 0; });
  if (const auto n = drop([](const TPoint3Df& p) { return !isFinite(p); }); n > 0)
    warnings.warnOnceOf(
        "not finite: " + label,
        std::to_string(n) + " points with NaN or infinite coordinates dropped from " + label);
}

std::string labelOf(const CObservation& obs)
{
  const std::string name = obs.GetRuntimeClass()->className;
  return obs.sensorLabel.empty() ? name : name + " '" + obs.sensorLabel + "'";
}

/** Reads the observation as a Scan, if it is one. */
template <class Scan>
bool readAs(const CObservation& obs, std::optional<SensorPoints>& out, PointWarnings& warnings)
{
  const auto* scan = dynamic_cast<const Scan*>(&obs);
  if (!scan) return false;
  out.emplace();
  try
  {
    out->points = pointsOf(*scan, warnings);
  }
  catch (const std::exception& e)
  {
    throw std::runtime_error(labelOf(obs) + " cannot be read: " + oneLine(e));
  }
  return true;
}

template <class... Scan>
bool isAny(const CObservation& obs)
{
  return (... || (dynamic_cast<const Scan*>(&obs) != nullptr));
}

}  // namespace

bool is3DScan(const CObservation& obs)
{
  return isAny<CObservation3DRangeScan, CObservationPointCloud, CObservationVelodyneScan,
               CObservationRotatingScan>(obs);
}

bool isScan(const CObservation& obs)
{
  return isAny<CObservation2DRangeScan>(obs) || is3DScan(obs);
}

std::optional<SensorPoints> sensorPoints(const CObservation& obs,
                                         const mrpt::poses::CPose3D& robotPose,
                                         PointWarnings* warnings)
{
  PointWarnings silent;
  PointWarnings& to = warnings ? *warnings : silent;
  std::optional<SensorPoints> out;
  const bool read = readAs<CObservation2DRangeScan>(obs, out, to) ||
                    readAs<CObservation3DRangeScan>(obs, out, to) ||
                    readAs<CObservationPointCloud>(obs, out, to) ||
                    readAs<CObservationVelodyneScan>(obs, out, to) ||
                    readAs<CObservationRotatingScan>(obs, out, to);
  if (!read) return std::nullopt;
  dropUnusable(out->points, labelOf(obs), to);
  mrpt::poses::CPose3D sensorOnRobot;
  obs.getSensorPose(sensorOnRobot);
  out->sensorPose = robotPose + sensorOnRobot;
  return out;
}

}  // namespace mrpt_mapconv::maps
