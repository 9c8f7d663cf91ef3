#include <mrpt_mapconv/eval/OccupancyScore.h>

#include "ComparedMaps.h"

namespace mrpt_mapconv::eval
{
using grid::Layer;

namespace
{
/** How well the map has one label within `reach` cells. */
Agreement agreement(const ComparedMaps& compared, std::int32_t reach, bool free)
{
  Agreement result;
  compared.forEachJudged(
      [&](std::int32_t x, std::int32_t y)
      {
        if (hasLabel(compared.said, x, y, 0, free))
          ++(hasLabel(compared.truth, x, y, reach, free) ? result.right : result.wrong);
        if (hasLabel(compared.truth, x, y, 0, free))
          ++(hasLabel(compared.said, x, y, reach, free) ? result.found : result.missed);
      });
  return result;
}

OccupancyScore score(const ComparedMaps& compared, std::int32_t reach)
{
  return {agreement(compared, reach, true), agreement(compared, reach, false)};
}

double shareFound(const OccupancyScore& score)
{
  const std::size_t found = score.free.found + score.occupied.found;
  return share(found, found + score.free.missed + score.occupied.missed);
}
}  // namespace

double Agreement::precision() const { return share(right, right + wrong); }
double Agreement::recall() const { return share(found, found + missed); }

OccupancyScore scoreOccupancy(const Layer<float>& map, const Layer<float>& truth,
                              const CellMask& judged)
{
  return score({map, truth, judged}, 0);
}

OccupancyScore scoreWithinOneCell(const Layer<float>& map, const Layer<float>& truth,
                                  const CellMask& judged)
{
  return score({map, truth, judged}, 1);
}

double shareRight(const Layer<float>& map, const Layer<float>& truth, const CellMask& judged)
{
  return shareFound(scoreOccupancy(map, truth, judged));
}

double shareRightWithinOneCell(const Layer<float>& map, const Layer<float>& truth,
                               const CellMask& judged)
{
  return shareFound(scoreWithinOneCell(map, truth, judged));
}

}  // namespace mrpt_mapconv::eval
