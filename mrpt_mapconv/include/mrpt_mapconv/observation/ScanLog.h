#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/system/COutputLogger.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::observation
{
/** A scan and where the robot was when it was taken. */
struct PosedObservation
{
  mrpt::obs::CObservation::Ptr observation;  //!< of a class that sensorPoints() reads
  mrpt::poses::CPose3D robotPose;            //!< robot -> map
};

/** The scans of an MRPT simplemap, each at the mean pose of its keyframe, in the file's order.
 *
 * Sets MRPT's lazy-load directory as readRawlog() does.
 * \param path a `.simplemap`, gzipped or not
 * \param log told of keyframes that have to be skipped; may be null
 * \exception std::runtime_error in one line naming the file: missing, empty, truncated, no
 * simplemap, or without any scan */
std::vector<PosedObservation> readSimpleMap(const std::string& path,
                                            const mrpt::system::COutputLogger* log = nullptr);

struct RawlogOptions
{
  /** The robot stood still: every scan is at the identity, poses in the log are not looked at. */
  bool staticSensor = false;
};

/** The scans of an MRPT rawlog, of either format, with the robot's pose at their time, in the
 * file's order.
 *
 * Poses come from the first of these that the log has:
 * 1. CObservationRobotPose (the mean; its sensorPose is not used), interpolated to the scan's time
 * by PoseTrack; of several sources, told apart by their label, the one with the most poses;
 * 2. CObservationOdometry, likewise;
 * 3. the increments of CActionCollection, summed up: a sensory frame is at the sum of all actions
 *    before it. Of wheel odometry the raw reading is taken, since MRPT draws the increment itself
 * at random for some motion models.
 *
 * Scans more than PoseTrack::kTolerance outside the time span of the poses are left out, and a
 * warning gives their number. In a log without poses a single 3D scan is at the identity, and 2D
 * scans are left out.
 *
 * Scans that are stored outside the log are read later, when their points are asked for. Therefore
 * this sets MRPT's global lazy-load directory (CImage::setImagesPathBase) to the log's image
 * directory, as MRPT's programs do, if there is one: NAME_Images beside NAME.rawlog, or else
 * Images.
 *
 * \param log told of what is left out; may be null
 * \exception std::runtime_error in one line naming the file: missing, empty, truncated (also in the
 * middle of an object), no rawlog, no 3D observations (2D scans alone do not count), several 3D
 * scans but no poses, or no 3D scan within the time span of the poses */
std::vector<PosedObservation> readRawlog(const std::string& path, const RawlogOptions& options = {},
                                         const mrpt::system::COutputLogger* log = nullptr);

}  // namespace mrpt_mapconv::observation
