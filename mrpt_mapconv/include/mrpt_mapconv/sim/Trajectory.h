#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt_mapconv/params/StrictSection.h>
#include <mrpt_mapconv/sim/World.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::sim
{
/** How way-points are driven along. */
struct Drive
{
  double speed = 0;           //!< along the straight lines [m/s]
  double turnRate = 0;        //!< while turning on the spot [rad/s]
  bool followGround = false;  //!< the way-points' z is found in the world
  double height = 0;          //!< of the robot's origin above the ground [m]; with followGround
  double headroom = 0.2;      //!< free space that it needs above its origin [m]; likewise
};

/** Where the robot is at which time: poses, linear in position and angles between them. */
class Trajectory
{
 public:
  struct Knot
  {
    double time = 0;                      //!< since the start [s]
    mrpt::math::TPoint3D position;        //!< of the robot in the map [m]
    double yaw = 0, pitch = 0, roll = 0;  //!< [rad]; yaw and roll beyond ±π instead of jumping
    int number = 0;                       //!< of the way-point or pose that it begins at, from 1
  };

  /** Reads section [trajectory]:
   * \code
   * waypoints = [0 0 0] [4 0 0] [4 3 0]     // x y z [m]; with followGround x y
   * speed = 0.5                             // [m/s]
   * turnRate = 45                           // on the spot, at way-points [degrees/s]
   * followGround = true                     // default: false
   * height = 0.3                            // robot's origin above the ground [m]
   * headroom = 0.2                          // free above it [m]
   * \endcode
   * or
   * \code
   * poses = [0  0 0 0  0 0 0] [2  1 0 0  90 0 0]   // t x y z yaw pitch roll [s, m, degrees]
   * \endcode
   * The ground is the top of the lowest solid with height + headroom of free space above it, at the
   * highest place within 5 cm ahead and behind.
   * Brackets are for the reader's eye only. The robot heads where it goes; time starts at 0.
   *
   * \exception std::runtime_error in one line naming section, key and value (of way-points and
   * poses the number), and what would be right */
  static Trajectory read(params::StrictSection& section, const World& world);

  /** Along way-points; none may lie where the one before it does (looked at from above, with
   * followGround). \exception std::invalid_argument naming the way-point's number and place */
  static Trajectory along(const std::vector<mrpt::math::TPoint3D>& wayPoints, const Drive& drive,
                          const World& world);
  /** \param knots at least two, of increasing time, the first at 0 */
  explicit Trajectory(std::vector<Knot> knots) : m_knots(std::move(knots)) {}

  const std::vector<Knot>& knots() const { return m_knots; }
  double duration() const { return m_knots.back().time; }  //!< [s]
  /** \param time [s]; before the start and after the end the robot stands. \return robot -> map */
  mrpt::poses::CPose3D poseAt(double time) const;
  /** True if z, pitch and roll are always 0, so that 2D odometry says everything. */
  bool isFlat() const;

 private:
  std::vector<Knot> m_knots;
};

/** "(1.5, 2, 0)" */
std::string placeText(const mrpt::math::TPoint3D& point);

}  // namespace mrpt_mapconv::sim
