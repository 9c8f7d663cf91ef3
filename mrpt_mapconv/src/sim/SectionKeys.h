#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <array>
#include <string>
#include <vector>

namespace mrpt_mapconv::sim
{
// What world files ask of their keys beyond what StrictSection does. All of these throw
// std::runtime_error in one line naming section, key and value, and what would be right.

/** Fails unless the key is there. \param meaning e.g. "two numbers, x y [m]" */
void require(params::StrictSection& section, const std::string& key, const std::string& meaning);

/** Exactly so many numbers within ±1e6. */
std::vector<double> readNumbers(params::StrictSection& section, const std::string& key,
                                std::size_t count, const std::string& meaning);
double readNumber(params::StrictSection& section, const std::string& key);    //!< must be there
double readPositive(params::StrictSection& section, const std::string& key);  //!< must be there
/** \param otherwise what a key that is not there means */
double readPositive(params::StrictSection& section, const std::string& key, double otherwise);
double readShare(params::StrictSection& section,
                 const std::string& key);  //!< 0 … 1; 0 if not there
mrpt::math::TPoint2D readPoint2D(params::StrictSection& section, const std::string& key);
mrpt::math::TPoint3D readPoint3D(params::StrictSection& section, const std::string& key);

/** A line through two or more points, x y x y … [m]; must be there. */
std::vector<mrpt::math::TPoint2D> readLine(params::StrictSection& section, const std::string& key);

/** Two numbers > 0, the second not below the first; must be there. */
struct Interval
{
  double low = 0, high = 0;

  /** \param share 0 … 1 */
  double at(double share) const { return low + share * (high - low); }
};
Interval readInterval(params::StrictSection& section, const std::string& key);

/** Keys min and max, x y [m]: opposite corners of a rectangle of positive size. */
struct Outline
{
  mrpt::math::TPoint2D min, max;

  mrpt::math::TPoint2D middle() const { return {(min.x + max.x) / 2, (min.y + max.y) / 2}; }
  mrpt::math::TPoint2D size() const { return {max.x - min.x, max.y - min.y}; }
};
Outline readOutline(params::StrictSection& section);

/** Keys min and max, the corners of a box of positive size. */
struct Corners
{
  mrpt::math::TPoint3D min, max;  //!< [m]

  mrpt::math::TPoint3D centre() const
  {
    return {(min.x + max.x) / 2, (min.y + max.y) / 2, (min.z + max.z) / 2};
  }
  mrpt::math::TPoint3D size() const { return {max.x - min.x, max.y - min.y, max.z - min.z}; }
};
Corners readCorners(params::StrictSection& section);

/** Key direction: towards +x, -x, +y or -y. */
struct Direction
{
  bool alongY = false;
  bool backwards = false;
};
Direction readDirection(params::StrictSection& section);

}  // namespace mrpt_mapconv::sim
