#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/cloud/CloudFields.h>

#include <array>
#include <string>

namespace mapconv
{
/** Where data lie along x, y and z. */
using Extent = std::array<mrpt_mapconv::cloud::Range, 3>;

/** Maps keep heights as floats once the origin is taken off.
 * \param extent of the data and \param origin, both in the input's units
 * \param units of x, y and z [m]
 * \exception std::runtime_error naming the input and an --origin that would do, if heights are
 * farther than 100 km from the origin's, or x or y than 100 000 km */
void requireNearOrigin(const std::string& name, const Extent& extent,
                       const mrpt::math::TPoint3D& origin,
                       const std::array<double, 3>& units = {1, 1, 1});

}  // namespace mapconv
