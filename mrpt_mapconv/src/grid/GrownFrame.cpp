#include <mrpt_mapconv/grid/GrownFrame.h>

#include <algorithm>

namespace mrpt_mapconv::grid
{
namespace
{
std::int32_t cellsOf(const GrowthMargin& margin, std::int32_t side, double resolution)
{
  const double most = std::min(margin.share * side, margin.most / resolution);
  return std::max(margin.least, static_cast<std::int32_t>(most));
}
}  // namespace

GridFrame grownFrame(const GridFrame& frame, const GridFrame& needed, const GrowthMargin& margin,
                     const std::function<bool(const GridFrame&)>& isAllowed)
{
  const GridFrame least = unite(frame, needed);
  const std::int32_t x = cellsOf(margin, least.width, least.resolution);
  const std::int32_t y = cellsOf(margin, least.height, least.resolution);
  const bool all = frame.empty();
  GridFrame roomy = least;
  if (all || least.x0 < frame.x0) roomy.x0 -= x;
  if (all || least.y0 < frame.y0) roomy.y0 -= y;
  roomy.width = least.xEnd() + (all || least.xEnd() > frame.xEnd() ? x : 0) - roomy.x0;
  roomy.height = least.yEnd() + (all || least.yEnd() > frame.yEnd() ? y : 0) - roomy.y0;
  return isAllowed(roomy) ? roomy : least;
}

}  // namespace mrpt_mapconv::grid
