#include <mrpt_mapconv/observation/RotatingScanPoints.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <type_traits>
#include <vector>

#include "MaxRange.h"

namespace mrpt_mapconv::observation
{
using mrpt::math::TPoint3Df;
using mrpt::obs::CObservationRotatingScan;
using mrpt::obs::VelodyneCalibration;

namespace
{
/** How the columns of a range image lie in azimuth, counter-clockwise [rad]. */
struct Columns
{
  double start, step;     //!< azimuth of column 0 and from one column to the next
  double stepPerRow = 0;  //!< the lasers of a column fire one after another

  double azimuth(int row, int column) const { return start + column * step + row * stepPerRow; }
};

/** As MRPT describes it: the span reaches from the first to the last column. */
Columns describedColumns(const CObservationRotatingScan& scan)
{
  const auto n = scan.rangeImage.cols();
  if (n == 1) return {scan.startAzimuth + scan.azimuthSpan / 2, 0};
  return {scan.startAzimuth, scan.azimuthSpan / static_cast<double>(n - 1)};
}

bool emptyFromColumn(const CObservationRotatingScan& scan, int first)
{
  for (int row = 0; row < scan.rangeImage.rows(); ++row)
    for (int column = first; column < scan.rangeImage.cols(); ++column)
      if (scan.rangeImage(row, column) != 0) return false;
  return true;
}

/** Columns that fromVelodyne() fills; 0 if the scan was not made by it. */
int columnsFromVelodyne(const CObservationRotatingScan& scan)
{
  constexpr int columnsPerPacket = 384;  // fromVelodyne() makes so many, whatever the model
  const int columns = static_cast<int>(scan.rangeImage.cols());
  if (columns % columnsPerPacket != 0) return 0;
  // A Velodyne turns clockwise, so a positive span means that azimuth is counted clockwise.
  if (scan.azimuthSpan <= 0) return 0;
  const int filled = columns / static_cast<int>(scan.rangeImage.rows());
  return emptyFromColumn(scan, filled) ? filled : 0;
}

Columns columnsOf(const CObservationRotatingScan& scan)
{
  int filled = columnsFromVelodyne(scan);
  if (filled == 0) return describedColumns(scan);
  // Dual return: two blocks share an azimuth, the second return is kept in another layer.
  if (!scan.rangeOtherLayers.empty()) filled /= 2;
  const double step = -scan.azimuthSpan / filled;
  // Time between two lasers over the time between two columns [µs], from Velodyne's manuals.
  const double perRow = scan.rangeImage.rows() == 16 ? 2.304 / 55.296 : 1.152 / 46.08;
  return {-scan.startAzimuth, step, step * perRow};
}

MaxRange maxRangeOf(const CObservationRotatingScan& scan)
{
  return MaxRange(scan.maxRange, scan.rangeResolution);
}

void planarPoints(const CObservationRotatingScan& scan, SensorPoints& out)
{
  const Columns columns = describedColumns(scan);
  const MaxRange most = maxRangeOf(scan);
  for (int column = 0; column < scan.rangeImage.cols(); ++column)
  {
    const double measured = scan.rangeImage(0, column) * scan.rangeResolution;
    if (measured <= 0) continue;
    const double range = most.cut(measured);
    const double azimuth = columns.azimuth(0, column);
    auto& points = most.isReachedBy(measured) ? out.noReturns : out.points;
    points.emplace_back(static_cast<float>(range * std::cos(azimuth)),
                        static_cast<float>(range * std::sin(azimuth)), 0.0f);
  }
}

void calibratedPoints(const CObservationRotatingScan& scan, const VelodyneCalibration& calibration,
                      SensorPoints& out)
{
  const Columns columns = columnsOf(scan);
  const MaxRange most = maxRangeOf(scan);
  for (int row = 0; row < scan.rangeImage.rows(); ++row)
  {
    const auto& laser = calibration.laser_corrections[static_cast<std::size_t>(row)];
    const double height = laser.verticalOffsetCorrection;
    const double aside = laser.horizontalOffsetCorrection;
    for (int column = 0; column < scan.rangeImage.cols(); ++column)
    {
      const double measured = scan.rangeImage(row, column) * scan.rangeResolution;
      if (measured <= 0 || measured < scan.minRange) continue;
      const double range = most.cut(measured);
      const double azimuth = columns.azimuth(row, column);
      const double level = range * laser.cosVertCorrection + height * laser.sinVertCorrection;
      const double c = std::cos(azimuth), s = std::sin(azimuth);
      auto& points = most.isReachedBy(measured) ? out.noReturns : out.points;
      points.emplace_back(static_cast<float>(level * c - aside * s),
                          static_cast<float>(level * s + aside * c),
                          static_cast<float>(range * laser.sinVertCorrection + height));
    }
  }
}

/** MRPT 2.5 has no organizedPoints. */
template <class Scan, class = void>
struct HasOrganizedPoints : std::false_type
{
};
template <class Scan>
struct HasOrganizedPoints<Scan, std::void_t<decltype(std::declval<Scan>().organizedPoints)>>
    : std::true_type
{
};

template <class Scan>
bool organizedPoints([[maybe_unused]] const Scan& scan,
                     [[maybe_unused]] std::vector<TPoint3Df>& points)
{
  if constexpr (HasOrganizedPoints<Scan>::value)
    for (const auto& point : scan.organizedPoints) points.push_back(point);
  return !points.empty();
}

double stepOf(const CObservationRotatingScan& scan)
{
  if (scan.rangeImage.size() == 0) return 0;
  return std::abs(scan.rangeImage.rows() == 1 ? describedColumns(scan).step : columnsOf(scan).step);
}

bool loadedPoints(const CObservationRotatingScan& scan, SensorPoints& out)
{
  out.azimuthStep = stepOf(scan);
  // One row first: newer MRPT's fromScan2D() fills organizedPoints in range units and not in
  // metres.
  if (scan.rangeImage.rows() == 1)
  {
    planarPoints(scan, out);
    return true;
  }
  if (organizedPoints(scan, out.points))
  {
    maxRangeOf(scan).sort(out, [](const TPoint3Df& point) { return point.norm(); });
    return true;
  }
  if (scan.rangeImage.size() == 0) return true;
  const VelodyneCalibration& calibration = shippedCalibration(scan.lidarModel);
  if (calibration.laser_corrections.size() != static_cast<std::size_t>(scan.rangeImage.rows()))
    return false;
  calibratedPoints(scan, calibration, out);
  return true;
}

}  // namespace

const VelodyneCalibration& shippedCalibration(const std::string& model)
{
  std::string name;
  for (const char c : model)
    if (std::isalnum(static_cast<unsigned char>(c)))
      name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (name == "HDL32E") name = "HDL32";
  // Not HDL64: MRPT 2.5 fails to parse that file of its own, and prints all of it.
  static const VelodyneCalibration none;
  if (name != "VLP16" && name != "HDL32") return none;
  return VelodyneCalibration::LoadDefaultCalibration(name);
}

bool rotatingScanPoints(const CObservationRotatingScan& scan, SensorPoints& out)
{
  out.clear();
  if (scan.rangeImage.size() != 0) return loadedPoints(scan, out);
  CObservationRotatingScan copy = scan;
  copy.load();
  return loadedPoints(copy, out);
}

}  // namespace mrpt_mapconv::observation
