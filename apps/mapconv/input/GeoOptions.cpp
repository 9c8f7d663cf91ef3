#include "input/GeoOptions.h"

#include <mrpt_mapconv/observation/FarPoses.h>

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "input/InputOptions.h"

namespace mapconv
{
using namespace mrpt_mapconv;

void addGeoOptions(CLI::App& app, GeoOptions& options)
{
  app.add_option_function<std::vector<double>>(
         "--origin",
         [&options](const std::vector<double>& place)
         { options.origin = mrpt::math::TPoint3D(place[0], place[1], place[2]); },
         "taken off the coordinates of scans [m]; files say so. Default: 0, or whole metres near a "
         "robot that is far away, as in UTM")
      ->expected(3)
      ->delimiter(',')
      ->check(isFinite())
      ->type_name("X,Y,Z");
  app.add_option("--crs", options.coordinateSystem,
                 "coordinate system of the input, for GeoTIFFs, e.g. EPSG:32633")
      ->check(CLI::Validator(
          [](std::string& text) -> std::string
          {
            try
            {
              grid::requireCoordinateSystem(text);
              return "";
            }
            catch (const std::runtime_error& error)
            {
              return error.what();
            }
          },
          ""))
      ->type_name("EPSG:N");
}

void noteOrigin(const GeoOptions& options, const std::string& why, NoEffect& noEffect)
{
  if (options.origin) noEffect.add({"--origin"}, why);
}

grid::GeoReference moveToOrigin(std::vector<observation::PosedObservation>& scans,
                                const GeoOptions& options, double resolution)
{
  const auto origin = options.origin.value_or(observation::originOf(scans, resolution));
  observation::moveToOrigin(scans, origin);
  return {origin, options.coordinateSystem};
}

}  // namespace mapconv
