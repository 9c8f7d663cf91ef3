#pragma once

#include <mrpt_mapconv/sim/Sensors.h>
#include <mrpt_mapconv/sim/Trajectory.h>
#include <mrpt_mapconv/sim/Truth.h>
#include <mrpt_mapconv/sim/World.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace mrpt_mapconv::sim
{
/** Section [noise]: what odometry and pose estimates are wrong by; all 0 without it. */
struct NoiseParams
{
  double odometryPerMetre = 0;     //!< standard deviation of x and y each, after 1 m [m]
  double odometryYawPerMetre = 0;  //!< standard deviation of the heading after 1 m [degrees]
  double odometryYawPerTurn = 0;   //!< likewise after one full turn [degrees]
  double odometryDrift = 0;        //!< systematic turn to the left [degrees per metre]
  double posePosition = 0;         //!< standard deviation of a pose estimate's x, y, z [m]
  double poseAngle = 0;            //!< likewise of its yaw, pitch and roll [degrees]
  double poseHeight = 0;           //!< of its z alone, beside posePosition [m]
  double poseTilt = 0;             //!< of its pitch and roll alone, beside poseAngle [degrees]

  /** Standard deviation of all that an estimate's z is wrong by [m]. */
  double poseZ() const { return std::hypot(posePosition, poseHeight); }
  /** Likewise of its pitch, and of its roll [degrees]. */
  double posePitchRoll() const { return std::hypot(poseAngle, poseTilt); }
};

/** Section [log]: what is written. */
struct LogParams
{
  bool poses = false;     //!< observation log: also pose estimates (CObservationRobotPose)
  int keyFrameEvery = 1;  //!< simplemap: every how manyth moment with a 3D scan is a key frame
};

/** A world, a robot in it, and what is to be known about both: all that a simulation needs. */
struct Scenario
{
  World world;
  std::vector<std::unique_ptr<const Sensor>> sensors;  //!< at least one, by their names
  Trajectory trajectory;
  NoiseParams noise;
  LogParams log;
  TruthParams truth;             //!< section [truth]
  double truthResolution = 0.1;  //!< of the truth's layers [m]; likewise

  /** Reads a world file: the sections of World, [sensor.NAME], [trajectory], and [noise], [log] and
   * [truth] with the keys above (and `resolution` in [truth]), which may be left out.
   *
   * The way must lead through free space within the world's bounds: the robot's origin (a
   * centimetre above it, since it may stand on a floor) and every sensor are tried each 5 cm. It
   * must take at most 24 h. At least one body must be there, each at least partly within the
   * bounds, and the truth may have 4e7 cells. share/doc/worlds.md is for who writes such a file.
   * \param sensors names of those that the robot has; empty: all that are not spare
   * \exception std::runtime_error in one line "FILE: section 'x': …" naming key and value, and what
   * would be right; also for sections and keys that mean nothing, for the name of a sensor that is
   * not there, and if the file cannot be read */
  static Scenario load(const std::string& file, const std::vector<std::string>& sensors = {});
};

}  // namespace mrpt_mapconv::sim
