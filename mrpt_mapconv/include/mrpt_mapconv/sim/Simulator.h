#pragma once

#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/system/datetime.h>
#include <mrpt_mapconv/sim/RayCaster.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace mrpt_mapconv::sim
{
/** What the robot knows and what is true at an instant at which sensors see something. */
struct Moment
{
  double seconds = 0;                  //!< since the start
  mrpt::system::TTimeStamp time;       //!< the start is 2025-01-01 00:00 UTC, always
  mrpt::poses::CPose3D pose;           //!< true, robot -> map
  mrpt::poses::CPose3D estimatedPose;  //!< with the noise of pose estimates
  mrpt::poses::CPose2D odometry;       //!< absolute; begins at the true pose
  std::vector<Scan> scans;             //!< of the sensors that are due, by their names
  bool keyFrame = false;               //!< due for the simplemap
};

/** At which times which sensors are due: sensor s for the k-th time at k/rate, from the start to
 * the trajectory's end. Times are counted in MRPT's ticks of 100 ns. */
class Schedule
{
 public:
  struct Slot
  {
    std::int64_t ticks = 0;                //!< since the start
    std::vector<std::size_t> sensors;      //!< that are due
    std::vector<std::uint64_t> scanIndex;  //!< of each of them: how many it made before
    bool keyFrame = false;
  };
  explicit Schedule(const Scenario& scenario);
  /** \return nothing at the end */
  std::optional<Slot> next();

 private:
  std::int64_t dueTicks(std::size_t sensor) const;

  const Scenario& m_scenario;
  std::vector<std::uint64_t> m_made;  //!< scans of each sensor so far
  std::int64_t m_end;
  bool m_any3D = false;
  std::uint64_t m_candidates = 0;  //!< for key frames
};

/** Standard deviations of what odometry says about a step; their squares grow with the way, so that
 * it does not matter into how many steps a way is cut. */
struct OdometrySpread
{
  double position = 0;  //!< of x and y each [m]
  double yaw = 0;       //!< [rad]
};
OdometrySpread odometrySpread(const mrpt::poses::CPose2D& step, const NoiseParams& noise);

/** Lets a scenario happen, moment by moment. Everything random depends on the seed and on what it
 * is about, not on the order of computation. */
class Simulator
{
 public:
  /** The scenario must outlive the simulator. */
  Simulator(const Scenario& scenario, std::uint64_t seed);

  /** The next moment; nothing at the end. */
  std::optional<Moment> next();

 private:
  void moveOdometry(const mrpt::poses::CPose2D& truth);
  mrpt::poses::CPose3D estimateOf(const mrpt::poses::CPose3D& pose) const;

  const Scenario& m_scenario;
  const std::uint64_t m_seed;
  RayCaster m_caster;
  Schedule m_schedule;
  std::uint64_t m_moments = 0;
  mrpt::poses::CPose2D m_truth, m_odometry;
};

}  // namespace mrpt_mapconv::sim
