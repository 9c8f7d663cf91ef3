#include <mrpt_mapconv/eval/NoPath.h>
#include <mrpt_mapconv/planning/GridPlanner.h>

#include <initializer_list>

#include "ComparedMaps.h"

namespace mrpt_mapconv::eval
{
using grid::Layer;
using mrpt::math::TPoint2D;

namespace
{
using IsFreed = bool (*)(float said);

/** A map on which those cells are free that are so in truth and of which it says what `isFreed`
 * asks for. */
Layer<float> freed(Layer<float> map, const Layer<float>& truth, IsFreed isFreed)
{
  for (std::size_t i = 0; i < map.cells().size(); ++i)
    if (grid::isFree(truth.cells()[i]) && isFreed(map.cells()[i])) map.cells()[i] = grid::kFree;
  return map;
}

bool isUnknown(float said) { return !isKnown(said); }
bool isAnything(float /*said*/) { return true; }
}  // namespace

bool canStand(const Layer<float>& occupancy, const TPoint2D& place, double radius)
{
  return planning::planOnGrid(occupancy, place, place, radius).found();
}

NoPath whyNoPath(const Layer<float>& map, const Layer<float>& truth, const TPoint2D& start,
                 const TPoint2D& goal, double radius)
{
  checkResolution(map.frame(), truth.frame());
  const grid::GridFrame frame = grid::unite(map.frame(), truth.frame());
  const auto said = map.onFrame(frame, grid::kUnknown);
  const auto truly = on(frame, truth, grid::kUnknown);
  const auto leads = [&](const Layer<float>& layer)
  { return planning::planOnGrid(layer, start, goal, radius).found(); };

  const auto withoutUnknown = freed(said, truly, isUnknown);
  for (const TPoint2D& end : {start, goal})
    if (!canStand(withoutUnknown, end, radius)) return NoPath::EndOccupied;
  for (const TPoint2D& end : {start, goal})
    if (!canStand(said, end, radius)) return NoPath::EndUnknown;
  if (leads(said)) return NoPath::Heights;
  if (leads(withoutUnknown)) return NoPath::Unknown;
  if (leads(freed(said, truly, grid::isOccupied))) return NoPath::FalseObstacle;
  if (leads(freed(said, truly, isAnything))) return NoPath::UnknownAndFalseObstacle;
  return NoPath::Truth;
}

}  // namespace mrpt_mapconv::eval
