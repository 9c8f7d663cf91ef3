#include <mrpt_mapconv/grid/CoordinateSystem.h>
#include <mrpt_mapconv/params/Text.h>

#include <cmath>
#include <stdexcept>

#include "GdalErrors.h"
#include "SpatialReference.h"

namespace mrpt_mapconv::grid
{
std::optional<SystemUnits> unitsOf(const std::string& coordinateSystem)
{
  if (coordinateSystem.empty()) return std::nullopt;
  const GdalErrors silenced;
  OGRSpatialReference system;
  if (!setSystem(system, coordinateSystem)) return std::nullopt;
  SystemUnits units;
  if (system.IsGeocentric()) units.kind = SystemKind::Geocentric;
  if (system.IsGeographic()) units.kind = SystemKind::Geographic;
  if (units.kind != SystemKind::Geographic) units.horizontal = system.GetLinearUnits();
  if (system.IsCompound()) units.vertical = system.GetTargetLinearUnits("VERT_CS");
  const auto isLength = [](double unit) { return std::isfinite(unit) && unit > 0; };
  if (!isLength(units.horizontal) || !isLength(units.ofHeights())) return std::nullopt;
  return units;
}

void requireCoordinateSystem(const std::string& coordinateSystem)
{
  OGRSpatialReference system;
  const GdalErrors silenced;
  if (!coordinateSystem.empty() && !setSystem(system, coordinateSystem))
    throw std::runtime_error("'" + coordinateSystem +
                             "' is no coordinate system that is known; EPSG:32633, say, would be");
}

std::string unitInWords(double metres)
{
  constexpr double kSame = 1e-7;  // files round: 0.3048006 is the foot of the surveys
  const auto is = [metres](double unit) { return std::abs(metres / unit - 1) < kSame; };
  if (is(1)) return "m";
  if (is(kFoot)) return "feet";
  if (is(kSurveyFoot)) return "US survey feet";
  return "units of " + params::shortestText(metres) + " m";
}

}  // namespace mrpt_mapconv::grid
