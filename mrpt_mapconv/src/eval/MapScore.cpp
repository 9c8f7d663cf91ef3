#include <mrpt_mapconv/eval/MapScore.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace mrpt_mapconv::eval
{
namespace
{
using grid::GridFrame;
using grid::Layer;

double share(std::size_t part, std::size_t all)
{
  return all > 0 ? static_cast<double>(part) / static_cast<double>(all)
                 : std::numeric_limits<double>::quiet_NaN();
}

void checkResolution(const GridFrame& a, const GridFrame& b)
{
  if (std::abs(a.resolution - b.resolution) > 1e-6 * a.resolution)
    throw std::invalid_argument("the map's cells are " + std::to_string(a.resolution) +
                                " m, those of the truth " + std::to_string(b.resolution) + " m");
}

/** A layer on another frame, whose resolution differs at most by rounding. */
template <class T>
Layer<T> on(GridFrame frame, const Layer<T>& layer, T fill)
{
  checkResolution(layer.frame(), frame);
  return layer.onFrame(frame, fill);
}

bool isKnown(float cell) { return grid::isFree(cell) || grid::isOccupied(cell); }

/** Map, truth and mask on the frame of the truth. */
struct Compared
{
  Compared(const Layer<float>& map, const Layer<float>& truth_, const CellMask& mask)
      : said(on(truth_.frame(), map, grid::kUnknown)),
        truth(truth_),
        judged(on(truth_.frame(), mask, std::uint8_t{0}))
  {
  }

  /** Calls see(x, y) for each judged cell whose truth is known. */
  template <class See>
  void forEachJudged(const See& see) const
  {
    for (std::int32_t y = 0; y < truth.frame().height; ++y)
      for (std::int32_t x = 0; x < truth.frame().width; ++x)
        if (judged.at(x, y) && isKnown(truth.at(x, y))) see(x, y);
  }

  Layer<float> said;
  const Layer<float>& truth;
  CellMask judged;
};

/** Whether a cell within `reach` cells of (x, y) has the label that is asked for. */
bool hasLabel(const Layer<float>& layer, std::int32_t x, std::int32_t y, std::int32_t reach,
              bool free)
{
  const GridFrame& frame = layer.frame();
  for (std::int32_t ny = std::max(y - reach, 0); ny <= std::min(y + reach, frame.height - 1); ++ny)
    for (std::int32_t nx = std::max(x - reach, 0); nx <= std::min(x + reach, frame.width - 1); ++nx)
    {
      const float cell = layer.at(nx, ny);
      if (free ? grid::isFree(cell) : grid::isOccupied(cell)) return true;
    }
  return false;
}

/** How well the map has one label within `reach` cells. */
Agreement agreement(const Compared& compared, std::int32_t reach, bool free)
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

OccupancyScore score(const Compared& compared, std::int32_t reach)
{
  return {agreement(compared, reach, true), agreement(compared, reach, false)};
}

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
  score.should = should.cells().size() - static_cast<std::size_t>(std::count(
                                             should.cells().begin(), should.cells().end(), 0));
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
  const Compared compared(map, truth, mask);
  compared.forEachJudged(
      [&](std::int32_t x, std::int32_t y)
      {
        const bool misses =
            grid::isOccupied(truth.at(x, y)) && grid::isFree(compared.said.at(x, y));
        count += misses ? 1 : 0;
      });
  return count;
}

std::vector<double> errorsOf(const Layer<float>& map, const Layer<float>& truth,
                             const CellMask& judged)
{
  const auto said = on(truth.frame(), map, std::numeric_limits<float>::quiet_NaN());
  const auto mask = on(truth.frame(), judged, std::uint8_t{0});
  std::vector<double> errors;
  for (std::size_t i = 0; i < truth.cells().size(); ++i)
  {
    const double error =
        static_cast<double>(said.cells()[i]) - static_cast<double>(truth.cells()[i]);
    if (mask.cells()[i] && std::isfinite(error)) errors.push_back(error);
  }
  return errors;
}

Rmse rmse(const Layer<float>& map, const Layer<float>& truth, const CellMask& judged)
{
  double sum = 0;
  const auto errors = errorsOf(map, truth, judged);
  for (const double error : errors) sum += error * error;
  return {std::sqrt(sum / static_cast<double>(errors.size())), errors.size()};
}

CellMask cellsOf(const sim::World& world, const std::vector<std::string>& names,
                 const GridFrame& frame)
{
  CellMask mask(frame, 0);
  std::vector<sim::Solid> solids;
  for (std::size_t i = 0; i < world.size(); ++i)
  {
    const std::string name = world.name(i).substr(world.name(i).find('.') + 1);
    if (std::none_of(names.begin(), names.end(),
                     [&](const std::string& start) { return name.rfind(start, 0) == 0; }))
      continue;
    for (std::int32_t y = 0; y < frame.height; ++y)
      for (std::int32_t x = 0; x < frame.width; ++x)
      {
        solids.clear();
        const double cx = (frame.x0 + x + 0.5) * frame.resolution;
        const double cy = (frame.y0 + y + 0.5) * frame.resolution;
        const sim::Footprint place = world.primitive(i).footprint();
        if (cx < place.xMin || cx > place.xMax || cy < place.yMin || cy > place.yMax) continue;
        world.primitive(i).appendSolids(cx, cy, solids);
        if (!solids.empty()) mask.at(x, y) = 1;
      }
  }
  return mask;
}

CellMask both(const CellMask& a, const CellMask& b)
{
  CellMask mask = on(a.frame(), b, std::uint8_t{0});
  for (std::size_t i = 0; i < mask.cells().size(); ++i)
    mask.cells()[i] = mask.cells()[i] && a.cells()[i];
  return mask;
}

CellMask cellsFrom(const Layer<float>& layer, float least)
{
  CellMask mask(layer.frame(), 0);
  for (std::size_t i = 0; i < mask.cells().size(); ++i) mask.cells()[i] = layer.cells()[i] >= least;
  return mask;
}

}  // namespace mrpt_mapconv::eval
