#include "input/CloudInput.h"

#include <mrpt/core/Clock.h>
#include <mrpt_mapconv/cloud/CloudFields.h>
#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/files/CloudFormat.h>
#include <mrpt_mapconv/grid/CoordinateSystem.h>
#include <mrpt_mapconv/observation/TrajectoryFile.h>
#include <mrpt_mapconv/params/Text.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "input/InputOptions.h"
#include "input/NearOrigin.h"
#include "input/SeemsGeographic.h"
#include "output/Console.h"
#include "output/Json.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using cloud::Field;
using cloud::PointCloud;
using grid::SystemKind;

namespace
{
constexpr const char* kReprojection =
    "reproject it, e.g. pdal translate IN.las OUT.las reprojection "
    "--filters.reprojection.out_srs=EPSG:32633";

cloud::CloudReading readingOf(const GeoOptions& geo, const std::string& columns)
{
  cloud::CloudReading reading{geo.origin, columns, grid::unitsOf(geo.coordinateSystem)};
  if (geo.unit) reading.units = grid::SystemUnits{SystemKind::Plane, *geo.unit, {}};
  return reading;
}

/** Maps are made in metres; --crs names a system that has lengths. */
void requireLengths(const PointCloud& cloud, const GeoOptions& geo, const std::string& name)
{
  if (!geo.coordinateSystem.empty() || !cloud.namedUnits) return;
  const auto kind = cloud.namedUnits->kind;
  if (kind == SystemKind::Plane) return;
  throw std::runtime_error(
      name + ": its coordinates are " +
      (kind == SystemKind::Geographic ? "degrees" : "geocentric, so its z is no height") +
      (cloud.coordinateSystem.compare(0, 4, "EPSG") == 0 ? " (" + cloud.coordinateSystem + ")"
                                                         : "") +
      ", and maps are made in metres: " + kReprojection);
}

void requireCloudNearOrigin(const PointCloud& cloud, const std::string& name)
{
  const std::array<double, 3> units = {cloud.unit, cloud.unit, cloud.heightUnit};
  Extent extent{};
  for (const Field axis : {Field::X, Field::Y, Field::Z})
    extent.at(indexOf(axis)) = rangeOf(cloud, axis).value_or(cloud::Range{0, 0});
  const auto& o = cloud.origin;
  requireNearOrigin(name, extent, {o.x / units[0], o.y / units[1], o.z / units[2]}, units);
}

/** The system's name, unless it is of no use. */
std::string knownSystem(const PointCloud& cloud, const GeoOptions& geo, const std::string& name)
{
  if (!geo.coordinateSystem.empty()) return geo.coordinateSystem;
  if (cloud.coordinateSystem.empty() || grid::unitsOf(cloud.coordinateSystem))
    return cloud.coordinateSystem;
  printWarning(name + ": its coordinate system is not known, so GeoTIFFs name none; --crs does");
  return "";
}

/** Poses in another frame than the points would give rays of many kilometres. */
void requireOneFrame(const SeenCloud& input, const std::string& name, const std::string& trajectory)
{
  constexpr double kFarthest = 100e3;  // [m]; from where no sensor sees a point
  const auto poses = input.sensor.bounds();
  double square = 0;
  for (const Field axis : {Field::X, Field::Y, Field::Z})
  {
    const double unit = axis == Field::Z ? input.cloud.heightUnit : input.cloud.unit;
    const auto points = rangeOf(input.cloud, axis).value_or(cloud::Range{0, 0});
    const auto i = indexOf(axis);
    const double gap =
        std::max({unit * points.min - poses.max[i], poses.min[i] - unit * points.max, 0.0});
    square += gap * gap;
  }
  if (square <= kFarthest * kFarthest) return;
  constexpr double kKilometre = 1e3;
  throw std::runtime_error(name + ": the poses of " + trajectory + " are " +
                           params::roundedText(std::round(std::sqrt(square) / kKilometre)) +
                           " km from its points; are both in one coordinate system and unit?");
}

std::string timesText(double from, double to)
{
  return params::placeText(from) + " to " + params::placeText(to) + " s";
}
}  // namespace

void addTrajectoryOptions(CLI::App& app, TrajectoryOptions& options)
{
  app.add_option("--trajectory", options.file,
                 "poses of the sensor of a cloud: lines of t x y z yaw pitch roll [s, m, rad], of "
                 "TUM's t x y z qx qy qz qw, or with a covariance")
      ->type_name("FILE");
  app.add_option("--time-unit", options.times.unit,
                 "unit of a cloud's times [s], default 1: 1e-6 for microseconds")
      ->check(isPositive())
      ->type_name("S");
  app.add_option("--time-offset", options.times.offset,
                 "added to a cloud's times to get those of the trajectory [s], default 0")
      ->check(isFinite())
      ->type_name("S");
}

void addColumnsOption(CLI::App& app, std::string& columns)
{
  app.add_option("--columns", columns,
                 "names of a text's columns, such as x,y,z,_,time, if it has no line of them")
      ->type_name("NAMES");
}

void noteCloudOptions(const TrajectoryOptions& trajectory, const std::string& columns,
                      const GeoOptions& geo, const std::string& file, NoEffect& noEffect)
{
  std::vector<std::string> given;
  if (!columns.empty()) given.emplace_back("--columns");
  if (geo.unit) given.emplace_back("--unit");
  if (!trajectory.file.empty()) given.emplace_back("--trajectory");
  const observation::CloudTimes unset;
  if (trajectory.times.unit != unset.unit) given.emplace_back("--time-unit");
  if (trajectory.times.offset != unset.offset) given.emplace_back("--time-offset");
  noEffect.add(given, file + " is no cloud of points");
}

void noteColumns(files::InputStream& stream, const std::string& columns, NoEffect& noEffect)
{
  const auto format = files::cloudFormatOf({stream.name(), stream.preview(), stream.fileSize()});
  if (!columns.empty() && format != files::CloudFormat::Text)
    noEffect.add({"--columns"}, stream.name() + " is no text of points");
}

CloudInput readCloudInput(files::InputStream& stream, const GeoOptions& geo,
                          const std::string& columns, NoEffect& noEffect)
{
  noteColumns(stream, columns, noEffect);
  CloudInput input;
  input.cloud = cloud::readCloud(stream, readingOf(geo, columns));
  requireLengths(input.cloud, geo, stream.name());
  requireCloudNearOrigin(input.cloud, stream.name());
  if (input.cloud.notFinite > 0)
    printWarning(params::counted(input.cloud.notFinite, "point") + " of " + stream.name() +
                 " left out: a coordinate is NaN or infinite");
  if (!geo.unit && geo.coordinateSystem.empty() && !input.cloud.namedUnits &&
      seemsGeographic(input.cloud))
    printWarning(stream.name() +
                 ": its coordinates seem to be degrees, but are taken for metres; " +
                 kReprojection);
  input.reference = referenceOf(input.cloud.origin, knownSystem(input.cloud, geo, stream.name()),
                                input.cloud.unit);
  return input;
}

SeenCloud readSeenCloud(files::InputStream& stream, const GeoOptions& geo,
                        const std::string& columns, const TrajectoryOptions& trajectory,
                        NoEffect& noEffect)
{
  const std::string name = stream.name();
  if (trajectory.file.empty())
    throw std::runtime_error(
        name +
        ": is a cloud of points, which does not say from where they were seen: --trajectory "
        "FILE with the sensor's poses is missing; info and ground do without");
  SeenCloud input{readCloudInput(stream, geo, columns, noEffect), {}};
  if (input.cloud.time.empty())
    throw std::runtime_error(name +
                             ": its points have no times, so nobody knows from where each was "
                             "seen; info and ground do without");
  input.sensor =
      observation::readTrajectoryFile(trajectory.file, {input.cloud.unit, input.cloud.heightUnit});
  requireOneFrame(input, name, trajectory.file);
  return input;
}

void checkCovered(const SeenCloud& input, const std::string& file,
                  const TrajectoryOptions& trajectory, std::size_t used, std::size_t uncovered)
{
  const auto& times = trajectory.times;
  if (used == 0)
  {
    const auto range = rangeOf(input.cloud, Field::Time).value_or(cloud::Range{NAN, NAN});
    throw std::runtime_error(
        file + ": not one of its points has a time that " + trajectory.file + " covers: they are " +
        timesText(times.unit * range.min + times.offset, times.unit * range.max + times.offset) +
        ", the poses " +
        timesText(mrpt::Clock::toDouble(input.sensor.begin()),
                  mrpt::Clock::toDouble(input.sensor.end())) +
        "; --time-unit and --time-offset bring the former to the latter");
  }
  if (uncovered > 0)
    printWarning(std::to_string(uncovered) + " of " + params::counted(input.cloud.size(), "point") +
                 " left out: " + trajectory.file + " has no pose at their times");
}

std::string describeCloud(const PointCloud& cloud, std::size_t points)
{
  std::string text = "cloud (" + params::counted(points, "point");
  if (cloud.unit != 1 || cloud.heightUnit != 1) text += " in " + grid::unitInWords(cloud.unit);
  if (cloud.heightUnit != cloud.unit) text += ", heights in " + grid::unitInWords(cloud.heightUnit);
  return text + ")";
}

}  // namespace mapconv
