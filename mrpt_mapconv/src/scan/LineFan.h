#pragma once

#include <cstdint>
#include <vector>

namespace mrpt_mapconv::scan
{
/** A direction to look along, as a walk through cells needs it: it goes on along its major axis,
 * and along the other one, its minor axis, at most as fast. */
struct Line
{
  bool alongY = false;               //!< y is the major axis, and x the minor one
  int majorSign = 1, minorSign = 1;  //!< which way, +1 or −1
  double majorPerMinor = 0;          //!< ≥ 1; infinite along an axis
  double minorShare = 0;             //!< sine of the angle to the major axis, ≥ 0
  double diamondAngle = 0;           //!< its azimuth, see diamondAngleOf()
};

/** A direction as a number in [0, 4) that grows with the azimuth, at most as fast as that does in
 * radians: the place where it meets the square |x| + |y| = 1. Cheaper than an angle. */
double diamondAngleOf(double x, double y);

/** The line with this direction, of any length but 0. */
Line lineTowards(double x, double y);

/** Lines at even azimuths, the first along +x: line i of n at 2π·i/n. Turned by a quarter they are
 * exactly the same, if n is divisible by 4. */
class LineFan
{
 public:
  /** Nothing is allocated for a number that is the last one or smaller. */
  void setCount(std::int32_t lines);
  std::int32_t count() const { return m_count; }
  double step() const;  //!< from one line to the next [rad]
  const Line& line(std::int32_t i) const { return m_lines[static_cast<std::size_t>(i)]; }

 private:
  Line makeLine(std::int32_t i) const;

  std::int32_t m_count = 0;
  std::vector<double> m_sines;  //!< sin(π/2·j/n), j = 0 … n
  std::vector<Line> m_lines;
};

/** The smallest number of lines that is divisible by 4 and leaves neighbours at most `spacing`
 * apart at a range (in the same unit). */
std::int32_t linesFor(double range, double spacing);

}  // namespace mrpt_mapconv::scan
