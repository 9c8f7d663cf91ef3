#pragma once

#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <vector>

namespace mrpt_mapconv::path
{
/** The part of a straight segment that lies in one column; what only touches a column is none. */
struct SegmentColumn
{
  std::int32_t kx, ky;
  mrpt::math::TPoint3D from, to;  //!< [m]
};

/** The columns that a segment crosses, from its begin on; a single one if it has no length in x and
 * y.
 * \param resolution of the columns [m] */
std::vector<SegmentColumn> columnsOf(const mrpt::math::TPoint3D& from,
                                     const mrpt::math::TPoint3D& to, double resolution);

}  // namespace mrpt_mapconv::path
