#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <cstdint>

namespace mrpt_mapconv::sim
{
/** A smooth surface without steps: a tilted plane and noise over it. */
struct Relief
{
  double base = 0;                //!< height of the plane at x = y = 0 [m]
  mrpt::math::TPoint2D gradient;  //!< of the plane [m/m]
  double amplitude = 0;           //!< the first octave reaches this far from the plane [m]
  double wavelength = 1;          //!< distance of the first octave's random values [m]
  std::int32_t octaves = 1;       //!< each has half the amplitude and wavelength of the last
  std::uint32_t seed = 1;

  /** Reads keys of these names, all optional but a wavelength for an amplitude.
   * \exception std::runtime_error naming section, key and value, and what would be right */
  static Relief read(params::StrictSection& section);
  double heightAt(double x, double y) const;  //!< [m]
};

}  // namespace mrpt_mapconv::sim
