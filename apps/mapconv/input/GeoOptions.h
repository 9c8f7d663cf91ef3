#pragma once

#include <mrpt_mapconv/grid/GeoReference.h>
#include <mrpt_mapconv/observation/ScanLog.h>

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "input/NoEffect.h"

namespace mapconv
{
/** Where a map is said to lie. */
struct GeoOptions
{
  std::optional<mrpt::math::TPoint3D> origin;  //!< what is taken off coordinates; none: by itself
  std::string coordinateSystem;                //!< of the input's coordinates; empty: not known
  std::optional<double> unit;  //!< of a cloud's coordinates [m]; none: as the system or file says
};

/** The options for it: --origin and --crs. */
void addGeoOptions(CLI::App& app, GeoOptions& options);
/** The option --unit, of subcommands that read clouds. */
void addUnitOption(CLI::App& app, GeoOptions& options);

/** Notes --origin for an input that is in a frame of its own. */
void noteOrigin(const GeoOptions& options, const std::string& why, NoEffect& noEffect);

/** Where a local frame lies.
 * \param coordinateSystem empty: not known
 * \param unit of GeoTIFFs where that says none [m] */
mrpt_mapconv::grid::GeoReference referenceOf(const mrpt::math::TPoint3D& origin,
                                             const std::string& coordinateSystem, double unit = 1);

/** Takes off the poses of scans what was asked for, or what they need for a map near by.
 * \param name of the log, for messages
 * \param resolution of the voxel map [m]; 0: none
 * \exception std::runtime_error see requireNearOrigin() */
mrpt_mapconv::grid::GeoReference moveToOrigin(
    std::vector<mrpt_mapconv::observation::PosedObservation>& scans, const std::string& name,
    const GeoOptions& options, double resolution);

}  // namespace mapconv
