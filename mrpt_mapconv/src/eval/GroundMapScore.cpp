#include <mrpt_mapconv/eval/GroundMapScore.h>
#include <mrpt_mapconv/eval/LayerErrors.h>

namespace mrpt_mapconv::eval
{
namespace
{
template <class Chosen>
ErrorSummary errorsWhere(const aerial::GroundLayers& map, const grid::Layer<float>& truth,
                         const Chosen& chosen)
{
  CellMask judged(map.groundPoints.frame(), 0);
  for (std::size_t i = 0; i < judged.cells().size(); ++i)
    judged.cells()[i] = chosen(map.groundPoints.cells()[i]) ? 1 : 0;
  return summaryOf(errorsOf(map.ground, truth, judged));
}
}  // namespace

GroundMapScore scoreGroundMap(const aerial::GroundLayers& map, const grid::Layer<float>& truth)
{
  return {errorsWhere(map, truth, [](float) { return true; }),
          errorsWhere(map, truth, [](float points) { return points > 0; }),
          errorsWhere(map, truth, [](float points) { return points == 0; })};
}

}  // namespace mrpt_mapconv::eval
