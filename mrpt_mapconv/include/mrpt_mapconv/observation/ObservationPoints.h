#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt_mapconv/observation/SayOnceLog.h>
#include <mrpt_mapconv/observation/SensorPoints.h>

#include <optional>
#include <string>

namespace mrpt_mapconv::observation
{
/** True for the classes that sensorPoints() reads. */
bool isScan(const mrpt::obs::CObservation& obs);
/** True for those of them that are 3D data: all but CObservation2DRangeScan. */
bool is3DScan(const mrpt::obs::CObservation& obs);

/** How messages call an observation: its class and, if it has one, its label. */
std::string nameOf(const mrpt::obs::CObservation& obs);

/** The points of an observation in the frame of its sensor, and the sensor's pose in the map.
 *
 * - CObservation2DRangeScan: its valid ranges (deltaPitch is ignored, as MRPT's maps do);
 * - CObservation3DRangeScan: its points, or the unprojected range image if it has none;
 * - CObservationPointCloud: its cloud;
 * - CObservationVelodyneScan: its cloud, or the one MRPT generates from the packets, limited only
 * by the scan's own minRange;
 * - CObservationRotatingScan: see rotatingScanPoints().
 *
 * A return at the scan's maxRange or beyond it is none: the beam, cut there, goes to noReturns. A
 * point cloud has no maxRange. Of images of depths it is a depth, along the camera's axis. What is
 * marked as invalid (range 0, a ray that is not valid) gives neither.
 *
 * Nothing is thinned out. Points without return, that is (0, 0, 0), are dropped, as are points with
 * NaN or infinite coordinates; of the latter a warning gives the number. Externally stored data are
 * read from MRPT's lazy-load directory. The observation is not altered, not even by loading it.
 * azimuthStep is that of a rotating scan's columns, of the middle columns of a range camera whose
 * focal length is known, and of a Velodyne's packets; 0 for other scans.
 *
 * \param robotPose pose of the robot in the map
 * \param[out] out replaced; its memory is kept, so that a series of point clouds needs no more.
 * MRPT decodes packets, and unprojects range images, in a copy of the observation and with
 * allocations of its own
 * \param warnings told of what could not be used; may be null
 * \return false, and `out` as it was, if the class is none of these; no points if there were none,
 * or if the model of a rotating scanner is unknown
 * \exception std::runtime_error in one line naming class and label of the observation, if its data
 * are damaged or an external file is missing */
bool sensorPoints(const mrpt::obs::CObservation& obs, const mrpt::poses::CPose3D& robotPose,
                  SensorPoints& out, SayOnceLog* warnings = nullptr);
/** The same; nothing if the class is none of these. */
std::optional<SensorPoints> sensorPoints(const mrpt::obs::CObservation& obs,
                                         const mrpt::poses::CPose3D& robotPose,
                                         SayOnceLog* warnings = nullptr);

}  // namespace mrpt_mapconv::observation
