#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/grid/GeoReference.h>
#include <mrpt_mapconv/observation/ScanLog.h>

#include <string>

#include "input/GeoOptions.h"
#include "input/NoEffect.h"
#include "output/Progress.h"

namespace mapconv
{
/** Which points are wanted. */
struct PointRequest
{
  std::string file;                              //!< "-": what is piped in
  std::string columns;                           //!< of a text, as CloudReading::columns
  mrpt_mapconv::observation::RawlogOptions log;  //!< where the poses of a rawlog come from
  GeoOptions geo;                                //!< where the map lies
};

/** Points, from wherever they come. */
struct PointInput
{
  mrpt_mapconv::cloud::PointCloud cloud;
  mrpt_mapconv::grid::GeoReference reference;  //!< of the frame that the points are in
  std::string description;                     //!< what they were read from
};

/** Reads a cloud, or takes the points of 3D scans in the map frame, or the centres of a voxel map's
 * occupied voxels.
 * \param noEffect gets the options that have none
 * \exception std::runtime_error in one line naming the file and what is wrong with it */
PointInput readPoints(const PointRequest& request, NoEffect& noEffect, Progress& progress);

}  // namespace mapconv
