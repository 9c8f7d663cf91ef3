#include "EmptyCells.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "../grid/Parallel.h"

namespace mrpt_mapconv::aerial
{
using grid::Layer;

namespace
{
constexpr float kSmallestChange = 2e-5F;  // [m] of a cell in a step; then the membrane rests
constexpr int kMostSteps = 500;
constexpr std::size_t kFewCells = 131072;  // whose steps are shorter than waking threads
constexpr float kOverRelaxation = 1.7F;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/** Half as many cells in x and y; each has the mean height of those of its four that have one. */
Layer<float> coarser(const Layer<float>& fine)
{
  const grid::GridFrame& f = fine.frame();
  grid::GridFrame frame;
  frame.width = (f.width + 1) / 2;
  frame.height = (f.height + 1) / 2;
  Layer<float> coarse(frame, kNone);
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
    {
      float sum = 0, count = 0;
      for (std::int32_t v = 2 * y; v < std::min(2 * y + 2, f.height); ++v)
        for (std::int32_t u = 2 * x; u < std::min(2 * x + 2, f.width); ++u)
          if (const float z = fine.at(u, v); !std::isnan(z)) sum += z, ++count;
      if (count > 0) coarse.at(x, y) = sum / count;
    }
  return coarse;
}

/** The empty cells of a layer, as on a chessboard: first those on black squares, then the others.
 * A cell's neighbours are of the other colour, so those of one can be moved in any order. */
using EmptyByColour = std::array<std::vector<std::uint32_t>, 2>;

EmptyByColour emptyCells(const Layer<float>& heights)
{
  EmptyByColour empty;
  for (std::int32_t y = 0; y < heights.frame().height; ++y)
    for (std::int32_t x = 0; x < heights.frame().width; ++x)
      if (std::isnan(heights.at(x, y)))
        empty[static_cast<std::size_t>((x + y) & 1)].push_back(static_cast<std::uint32_t>(
            heights.frame().indexOfKey(heights.frame().x0 + x, heights.frame().y0 + y)));
  return empty;
}

float meanOfNeighbours(const Layer<float>& heights, std::uint32_t cell)
{
  const auto width = static_cast<std::uint32_t>(heights.frame().width);
  const std::uint32_t x = cell % width;
  const float* z = heights.cells().data();
  float sum = 0, count = 0;
  if (x > 0) sum += z[cell - 1], ++count;
  if (x + 1 < width) sum += z[cell + 1], ++count;
  if (cell >= width) sum += z[cell - width], ++count;
  if (cell + width < heights.cells().size()) sum += z[cell + width], ++count;
  return sum / count;
}

/** Moves cells to (and beyond) the mean of their neighbours. \return the largest move [m] */
float relax(Layer<float>& heights, const std::vector<std::uint32_t>& cells, int threads)
{
  std::atomic<float> largest{0};
  grid::inParallel(cells.size(), threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     float most = 0;
                     for (std::size_t i = begin; i < end; ++i)
                     {
                       float& z = heights.cells()[cells[i]];
                       const float move = meanOfNeighbours(heights, cells[i]) - z;
                       z += kOverRelaxation * move;
                       most = std::max(most, std::abs(move));
                     }
                     float known = largest.load();
                     while (known < most && !largest.compare_exchange_weak(known, most))
                     {
                     }
                   });
  return largest;
}
}  // namespace

void fillEmptyCells(Layer<float>& heights, int threads)
{
  if (heights.cells().size() < kFewCells) threads = 1;
  const EmptyByColour empty = emptyCells(heights);
  const std::size_t count = empty[0].size() + empty[1].size();
  if (count == 0) return;
  if (count == heights.cells().size())
    throw std::invalid_argument("no cell has a height that others could be filled from");
  Layer<float> start = coarser(heights);
  fillEmptyCells(start, threads);
  const auto width = static_cast<std::uint32_t>(heights.frame().width);
  for (const auto& cells : empty)
    for (const std::uint32_t cell : cells)
      heights.cells()[cell] = start.at(static_cast<std::int32_t>(cell % width / 2),
                                       static_cast<std::int32_t>(cell / width / 2));
  for (int step = 0; step < kMostSteps; ++step)
  {
    const float black = relax(heights, empty[0], threads);
    const float white = relax(heights, empty[1], threads);
    if (std::max(black, white) < kSmallestChange) return;
  }
}

}  // namespace mrpt_mapconv::aerial
