#include "input/GeoOptions.h"

#include <mrpt/math/TBoundingBox.h>
#include <mrpt_mapconv/grid/CoordinateSystem.h>
#include <mrpt_mapconv/observation/FarPoses.h>

#include <CLI/CLI.hpp>
#include <map>
#include <stdexcept>

#include "input/InputOptions.h"
#include "input/NearOrigin.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** Accepts systems in which maps can lie. */
CLI::Validator isPlaneSystem()
{
  return CLI::Validator(
      [](std::string& text) -> std::string
      {
        try
        {
          grid::requireCoordinateSystem(text);
        }
        catch (const std::runtime_error& error)
        {
          return error.what();
        }
        const auto units = grid::unitsOf(text);
        if (!units || units->kind == grid::SystemKind::Plane) return "";
        return "'" + text +
               "' is not valid: maps are made in lengths, not in degrees or from the middle of the "
               "Earth; give a projected system, e.g. EPSG:32633";
      },
      "");
}

Extent extentOf(const std::vector<observation::PosedObservation>& scans)
{
  auto box = mrpt::math::TBoundingBox::PlusMinusInfinity();
  for (const auto& scan : scans) box.updateWithPoint(scan.robotPose.translation());
  return {{{box.min.x, box.max.x}, {box.min.y, box.max.y}, {box.min.z, box.max.z}}};
}
}  // namespace

void addGeoOptions(CLI::App& app, GeoOptions& options)
{
  app.add_option_function<std::vector<double>>(
         "--origin",
         [&options](const std::vector<double>& place)
         { options.origin = mrpt::math::TPoint3D(place[0], place[1], place[2]); },
         "taken off the coordinates of scans [m], or of a cloud in its own unit; files say so. "
         "Default: 0, or whole metres near the first pose or point if it is far away, as in UTM")
      ->expected(3)
      ->delimiter(',')
      ->check(isOnEarth())
      ->type_name("X,Y,Z");
  app.add_option("--crs", options.coordinateSystem,
                 "coordinate system of the input, for GeoTIFFs, e.g. EPSG:32633")
      ->check(isPlaneSystem())
      ->type_name("EPSG:N");
}

void addUnitOption(CLI::App& app, GeoOptions& options)
{
  static const std::map<std::string, double> units = {
      {"m", 1}, {"ft", grid::kFoot}, {"us-ft", grid::kSurveyFoot}};
  app.add_option_function<std::string>(
         "--unit", [&options](const std::string& name) { options.unit = units.at(name); },
         "unit of a cloud's x, y and z: m, ft or us-ft; default: that of --crs, else what the file "
         "names, else m")
      ->check(CLI::IsMember(units).description(""))
      ->type_name("UNIT");
}

void noteOrigin(const GeoOptions& options, const std::string& why, NoEffect& noEffect)
{
  if (options.origin) noEffect.add({"--origin"}, why);
}

grid::GeoReference referenceOf(const mrpt::math::TPoint3D& origin,
                               const std::string& coordinateSystem, double unit)
{
  if (const auto units = grid::unitsOf(coordinateSystem)) unit = units->horizontal;
  return {origin, coordinateSystem, unit};
}

grid::GeoReference moveToOrigin(std::vector<observation::PosedObservation>& scans,
                                const std::string& name, const GeoOptions& options,
                                double resolution)
{
  const auto origin = options.origin.value_or(observation::originOf(scans, resolution));
  if (!scans.empty()) requireNearOrigin(name, extentOf(scans), origin);
  observation::moveToOrigin(scans, origin);
  return referenceOf(origin, options.coordinateSystem);
}

}  // namespace mapconv
