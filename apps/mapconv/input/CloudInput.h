#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/files/InputStream.h>
#include <mrpt_mapconv/grid/GeoReference.h>
#include <mrpt_mapconv/observation/CloudTimes.h>
#include <mrpt_mapconv/observation/PoseTrack.h>

#include <CLI/App.hpp>
#include <cstddef>
#include <string>

#include "input/GeoOptions.h"
#include "input/NoEffect.h"

namespace mapconv
{
/** From where the points of a cloud were seen. */
struct TrajectoryOptions
{
  std::string file;                             //!< poses of the sensor over time; empty: none
  mrpt_mapconv::observation::CloudTimes times;  //!< how the cloud's times become those of it
};

/** The options for it: --trajectory, --time-unit and --time-offset. */
void addTrajectoryOptions(CLI::App& app, TrajectoryOptions& options);
/** The option --columns of texts without names. */
void addColumnsOption(CLI::App& app, std::string& columns);
/** Notes those that were given, for an input that is no cloud. */
void noteCloudOptions(const TrajectoryOptions& trajectory, const std::string& columns,
                      const GeoOptions& geo, const std::string& file, NoEffect& noEffect);
/** Notes --columns for a file of points that is no text. */
void noteColumns(mrpt_mapconv::files::InputStream& stream, const std::string& columns,
                 NoEffect& noEffect);

/** A cloud in metres, and where it lies. */
struct CloudInput
{
  mrpt_mapconv::cloud::PointCloud cloud;
  mrpt_mapconv::grid::GeoReference reference;
};

/** Reads a cloud. Warns of one that seems to be in degrees, and of a coordinate system that is not
 * known.
 * \exception std::runtime_error in one line naming the file and what is wrong with it, also if its
 * coordinates are degrees, or too far from the origin */
CloudInput readCloudInput(mrpt_mapconv::files::InputStream& stream, const GeoOptions& geo,
                          const std::string& columns, NoEffect& noEffect);

/** A cloud, and the poses of the sensor that saw it, in its coordinates [m] before the origin was
 * taken off. */
struct SeenCloud : CloudInput
{
  mrpt_mapconv::observation::PoseTrack sensor;
};

/** The same of a cloud with times. The trajectory's lengths are in the cloud's units.
 * \exception std::runtime_error likewise, also if times or trajectory are missing (it says which
 * commands do without), or if poses and points are more than 100 km apart */
SeenCloud readSeenCloud(mrpt_mapconv::files::InputStream& stream, const GeoOptions& geo,
                        const std::string& columns, const TrajectoryOptions& trajectory,
                        NoEffect& noEffect);

/** Warns of points at whose times the trajectory has no pose.
 * \param used points at whose times it has one
 * \exception std::runtime_error with the times of both, if there are none */
void checkCovered(const SeenCloud& input, const std::string& file,
                  const TrajectoryOptions& trajectory, std::size_t used, std::size_t uncovered);

/** What it was, for summaries: "cloud (3 points in feet)". */
std::string describeCloud(const mrpt_mapconv::cloud::PointCloud& cloud, std::size_t points);

}  // namespace mapconv
