#include "InferredLength.h"

#include <mrpt_mapconv/freespace/Evidence.h>

#include <cmath>

#include "SegmentColumns.h"

namespace mrpt_mapconv::path
{
double inferredLength(const std::vector<LiftedPoint>& points, const freespace::Layers& layers)
{
  using mrpt::math::TPoint3D;
  const grid::GridFrame& frame = layers.frame();
  const auto isInferred = [&](const SegmentColumn& column)
  {
    return frame.containsKey(column.kx, column.ky) &&
           layers.evidence.cells()[frame.indexOfKey(column.kx, column.ky)] ==
               freespace::evidence::kInferred;
  };
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    // points that cannot be reached have no height
    const auto &a = points[i - 1].position, &b = points[i].position;
    for (const SegmentColumn& column :
         columnsOf(TPoint3D(a.x, a.y, 0), TPoint3D(b.x, b.y, 0), frame.resolution))
      if (isInferred(column))
        sum += std::hypot(column.to.x - column.from.x, column.to.y - column.from.y);
  }
  return sum;
}

}  // namespace mrpt_mapconv::path
