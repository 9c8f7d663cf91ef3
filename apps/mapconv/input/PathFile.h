#pragma once

#include <mrpt/math/TPoint2D.h>

#include <string>
#include <vector>

namespace mapconv
{
/** Reads the columns x and y [m] of a CSV file: a header that names them among others, or none and
 * then x,y or x,y,z; a point a line. Empty lines and such that begin with # are passed over.
 * \param file "-": what is piped in
 * \param file "-": what is piped in
 * \exception std::runtime_error naming file and line, and what is wrong there */
std::vector<mrpt::math::TPoint2D> readPath2D(const std::string& file);

}  // namespace mapconv
