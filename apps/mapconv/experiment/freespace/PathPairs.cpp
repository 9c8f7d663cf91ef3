#include "experiment/freespace/PathPairs.h"

#include <mrpt_mapconv/planning/GridPlanner.h>

#include <cstdint>
#include <random>

namespace mapconv
{
using namespace mrpt_mapconv;
using mrpt::math::TPoint2D;

namespace
{
constexpr std::uint64_t kSeed = 7;
constexpr double kLeastDistance = 5;  // between start and goal [m]
constexpr int kTriesPerPair = 50;

/** Centres of random cells of a mask. */
class RandomPlaces
{
 public:
  explicit RandomPlaces(const eval::CellMask& mask) : m_frame(mask.frame())
  {
    for (std::size_t i = 0; i < mask.cells().size(); ++i)
      if (mask.cells()[i]) m_cells.push_back(i);
  }
  bool empty() const { return m_cells.empty(); }
  TPoint2D next()
  {
    const std::size_t cell = m_cells[m_random() % m_cells.size()];
    const auto width = static_cast<std::size_t>(m_frame.width);
    const std::size_t column = cell % width, row = cell / width;
    return {(m_frame.x0 + static_cast<double>(column) + 0.5) * m_frame.resolution,
            (m_frame.y0 + static_cast<double>(row) + 0.5) * m_frame.resolution};
  }

 private:
  grid::GridFrame m_frame;
  std::vector<std::size_t> m_cells;
  std::mt19937_64 m_random{kSeed};
};
}  // namespace

std::vector<Pair> randomPairs(const grid::Layer<float>& truth, const eval::CellMask& inView,
                              double robotRadius, int count)
{
  RandomPlaces places(eval::both(eval::freeCells(truth), inView));
  std::vector<Pair> pairs;
  for (int i = 0; i < count * kTriesPerPair && !places.empty(); ++i)
  {
    if (static_cast<int>(pairs.size()) == count) break;
    const Pair pair{places.next(), places.next()};  // in that order: braces evaluate so
    if ((pair.goal - pair.start).norm() < kLeastDistance) continue;
    if (planning::planOnGrid(truth, pair.start, pair.goal, robotRadius).found())
      pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace mapconv
