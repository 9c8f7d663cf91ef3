#pragma once

#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/VelodyneCalibration.h>
#include <mrpt_mapconv/observation/SensorPoints.h>

#include <string>

namespace mrpt_mapconv::observation
{
/** The calibration that MRPT ships for a lidar model; empty if there is none.
 * \param model as in CObservationRotatingScan::lidarModel, e.g. "VLP-16", "VLP16", "HDL-32E" */
const mrpt::obs::VelodyneCalibration& shippedCalibration(const std::string& model);

/** The points of a rotating scanner in the sensor frame [m], and its beams without return: those
 * with a range from maxRange on.
 *
 * - One row: column i of n looks at azimuth startAzimuth + azimuthSpan·i/(n−1), in the xy plane.
 * - organizedPoints, where MRPT has them (newer than 2.5) and they are present.
 * - Several rows, one per laser of a model whose calibration MRPT ships: columns as above,
 * elevation from the calibration, ranges from minRange on.
 *
 * Scans made by CObservationRotatingScan::fromVelodyne() depart from MRPT's own description: their
 * azimuth counts clockwise and only the first columnCount/rowCount columns are filled. They are
 * recognised by that and give the points of the Velodyne scan, but for the unevenness of its
 * turning, which they do not record (0.2° in MRPT's sample).
 *
 * \param[out] out all but its pose is replaced
 * \return false if the elevation of the rows is not known
 * \exception std::exception from MRPT if an external file is missing */
bool rotatingScanPoints(const mrpt::obs::CObservationRotatingScan& scan, SensorPoints& out);

}  // namespace mrpt_mapconv::observation
