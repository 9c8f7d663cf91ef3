#include <mrpt_mapconv/eval/LabelScore.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "ComparedMaps.h"

namespace mrpt_mapconv::eval
{
using grid::GridFrame;
using grid::Layer;

namespace
{
/** The free cells that free cells join to that at (x, y) [m], side by side; the others are unknown.
 */
Layer<float> freeAround(const Layer<float>& truth, double x, double y)
{
  const GridFrame& frame = truth.frame();
  Layer<float> reached(frame, grid::kUnknown);
  std::vector<std::pair<std::int32_t, std::int32_t>> open;  // keys of cells
  const auto visit = [&](std::int32_t kx, std::int32_t ky)
  {
    if (!frame.containsKey(kx, ky)) return;
    const std::size_t cell = frame.indexOfKey(kx, ky);
    if (!grid::isFree(truth.cells()[cell]) || grid::isFree(reached.cells()[cell])) return;
    reached.cells()[cell] = grid::kFree;
    open.emplace_back(kx, ky);
  };
  constexpr double kFarthest = 1e9;  // of a key; 32 bits hold it
  const auto key = [&](double metres)
  {
    const double cell = std::floor(metres / frame.resolution);
    return static_cast<std::int32_t>(std::clamp(cell, -kFarthest, kFarthest));
  };
  visit(key(x), key(y));
  if (open.empty())
    throw std::invalid_argument("the place (" + std::to_string(x) + ", " + std::to_string(y) +
                                ") is not valid: its cell must be free in truth");
  while (!open.empty())
  {
    const auto [kx, ky] = open.back();
    open.pop_back();
    visit(kx - 1, ky);
    visit(kx + 1, ky);
    visit(kx, ky - 1);
    visit(kx, ky + 1);
  }
  return reached;
}
}  // namespace

double LabelScore::precision() const { return share(correct, labelled); }
double LabelScore::recall() const { return share(found, should); }
double LabelScore::fScore() const { return 2 * precision() * recall() / (precision() + recall()); }

CellMask cellsToLabel(const Layer<float>& truth, double x, double y)
{
  const GridFrame& frame = truth.frame();
  const auto reached = freeAround(truth, x, y);
  CellMask mask(frame, 0);
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
      mask.at(ix, iy) = grid::isFree(reached.at(ix, iy)) ||
                        (grid::isOccupied(truth.at(ix, iy)) && hasLabel(reached, ix, iy, 1, true));
  return mask;
}

LabelScore scoreLabels(const Layer<float>& map, const Layer<float>& truth, const CellMask& should)
{
  const auto right = on(map.frame(), truth, grid::kUnknown);
  const auto asked = on(map.frame(), should, std::uint8_t{0});
  LabelScore score;
  score.should = count(should);
  for (std::size_t i = 0; i < map.cells().size(); ++i)
  {
    const float cell = map.cells()[i];
    if (!isKnown(cell)) continue;
    const float truly = right.cells()[i];
    const bool correct = grid::isFree(cell) ? grid::isFree(truly) : grid::isOccupied(truly);
    ++score.labelled;
    score.correct += correct ? 1 : 0;
    score.found += correct && asked.cells()[i] ? 1 : 0;
  }
  return score;
}

std::size_t occupiedLabelledFree(const Layer<float>& map, const Layer<float>& truth,
                                 const CellMask& mask)
{
  std::size_t count = 0;
  const ComparedMaps compared(map, truth, mask);
  compared.forEachJudged(
      [&](std::int32_t x, std::int32_t y)
      {
        const bool misses =
            grid::isOccupied(truth.at(x, y)) && grid::isFree(compared.said.at(x, y));
        count += misses ? 1 : 0;
      });
  return count;
}

}  // namespace mrpt_mapconv::eval
