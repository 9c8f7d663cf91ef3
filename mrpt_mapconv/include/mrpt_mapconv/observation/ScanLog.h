#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/system/COutputLogger.h>
#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/observation/PoseCovariance.h>
#include <mrpt_mapconv/observation/PoseTrack.h>

#include <optional>
#include <string>
#include <vector>

namespace mrpt_mapconv::observation
{
/** A scan and where the robot was when it was taken. */
struct PosedObservation
{
  mrpt::obs::CObservation::Ptr observation;             //!< of a class that sensorPoints() reads
  mrpt::poses::CPose3D robotPose;                       //!< robot -> map
  std::optional<HeightCovariance> poseCovariance = {};  //!< where the log has one
};

/** Whether one of them is a 3D scan. */
bool has3DScan(const std::vector<PosedObservation>& scans);

/** The scans of an MRPT simplemap, each at the mean pose of its keyframe and with its covariance,
 * in the file's order.
 *
 * Sets MRPT's lazy-load directory as readRawlog() does.
 * \param path a `.simplemap`, gzipped or not
 * \param log told of keyframes that have to be skipped; may be null
 * \exception std::runtime_error in one line naming the file: missing, empty, truncated, no
 * simplemap, or without any scan */
std::vector<PosedObservation> readSimpleMap(const std::string& path,
                                            const mrpt::system::COutputLogger* log = nullptr);
/** The same of a file at its first object. */
std::vector<PosedObservation> readSimpleMap(files::ObjectFile& file,
                                            const mrpt::system::COutputLogger* log = nullptr);

struct RawlogOptions
{
  /** The robot stood still: every scan is at the identity, poses in the log are not looked at. */
  bool staticSensor = false;
  /** A scan between two poses is used only if both are that near in time [s]. */
  double maxPoseGap = PoseTrack::kMaxGap;
  /** Label of the observations that the poses come from; or "robotPose", "odometry" or
   * "increments"; or kind and label of one that shares its label, "odometry:base". Not given: of
   * the kind that comes first, the one with the most poses. */
  std::optional<std::string> poseSource = {};
};

/** The scans of an MRPT rawlog, of either format, with the robot's pose at their time, in the
 * file's order.
 *
 * Poses come from the first of these that the log has:
 * 1. CObservationRobotPose (mean and covariance, of the robot: sensorPose is taken off),
 * interpolated to the scan's time by PoseTrack; of several sources, told apart by their label, the
 * one with the most poses;
 * 2. CObservationOdometry, likewise;
 * 3. the increments of CActionCollection, summed up: a sensory frame is at the sum of all actions
 *    before it. Of wheel odometry the raw reading is taken, since MRPT draws the increment itself
 * at random for some motion models.
 *
 * Scans without a time, in gaps between poses (maxPoseGap), and more than PoseTrack::kTolerance
 * outside the time span of the poses are left out, and one warning gives their numbers. In a log
 * without poses a single scan is at the identity; so is a single 3D scan among 2D scans, which are
 * left out.
 *
 * Scans that are stored outside the log are read later, when their points are asked for. Therefore
 * this sets MRPT's global lazy-load directory (CImage::setImagesPathBase) to the log's image
 * directory, as MRPT's programs do, if there is one: NAME_Images beside NAME.rawlog, or else
 * Images.
 *
 * \param log told of what is left out; may be null
 * \exception std::runtime_error in one line naming the file: missing, empty, truncated (also in the
 * middle of an object), no rawlog, no scans, several but no poses, no poses of the wanted source,
 * or no scan whose pose is known, of the 3D scans if there are any */
std::vector<PosedObservation> readRawlog(const std::string& path, const RawlogOptions& options = {},
                                         const mrpt::system::COutputLogger* log = nullptr);
/** The same of a file at the log's first entry. */
std::vector<PosedObservation> readRawlog(files::ObjectFile& file, const RawlogOptions& options = {},
                                         const mrpt::system::COutputLogger* log = nullptr);

}  // namespace mrpt_mapconv::observation
