// Planes grow seed by seed, in the order of keys, whatever threads have looked at before.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "../mrpt_mapconv/src/terrain/PlaneGrowth.h"
#include "HandTiles.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::terrain;

using Key = std::pair<int, int>;  // y, x: row by row
using Heights = std::map<Key, std::int32_t>;

PlaneSearch search(std::mt19937& random)
{
  PlaneSearch search;
  search.tolerance = 400 + static_cast<double>(random() % 800);
  search.mostSlope = 1600;
  search.window = 2 + static_cast<std::int32_t>(random() % 6);
  search.hypotheses = 1 + static_cast<std::int32_t>(random() % 32);
  search.blockCells = 8;
  search.minCells = 3 + static_cast<std::int32_t>(random() % 40);
  return search;
}

/** Slopes and levels with noise, rubble between them, and holes. */
Heights heights(std::mt19937& random)
{
  Heights heights;
  const int noise = 1 + static_cast<int>(random() % 900), seed = static_cast<int>(random() % 7);
  for (int y = -20; y < 60; ++y)
    for (int x = -40; x < 50; ++x)
    {
      const int part = ((x + 40) / 17 + (y + 20) / 13 + seed) % 5;
      const int level = part == 0 ? 300 * x : part == 1 ? 5000 : part == 2 ? 200 * y - 90 * x : 0;
      const int off = static_cast<int>(random() % static_cast<unsigned>(part == 4 ? 9000 : noise));
      if (random() % 40 != 0) heights[{y, x}] = level + off;
    }
  return heights;
}

/** One seed after the other, cell by cell; first with half of the tolerance. */
class SlowGrowth
{
 public:
  SlowGrowth(const PlaneSearch& search, const Heights& heights)
      : m_search(search), m_heights(heights)
  {
    for (const auto& [key, z] : heights) test::putCell(m_tiles, key.second, key.first, z);
  }

  std::map<Key, int> grow()
  {
    for (const double tolerance : {m_search.tolerance / 2, m_search.tolerance})
      for (const auto& entry : m_heights)
        if (!m_planes.count(entry.first)) growFrom(entry.first, tolerance);
    return m_planes;
  }

 private:
  void growFrom(const Key& seed, double tolerance)
  {
    PlaneSearch now = m_search;
    now.tolerance = tolerance;
    SeedPlane seedPlane(now);
    const CellRef cell = m_tiles.cell(seed.second, seed.first);
    if (!seedPlane.isPromising(cell)) return;
    const auto found = seedPlane.find(cell);
    PlaneMoments moments;
    if (!found || !flood(seed, *found, tolerance, moments)) return;
    const bool isFlat = moments.rms() <= 0.45 * tolerance;
    if (tolerance < m_search.tolerance && !isFlat) return;
    if (!flood(seed, moments.fit(), m_search.tolerance, moments)) return;
    for (const Key& key : m_reached)
    {
      const CellRef reached = m_tiles.cell(key.second, key.first);
      reached.tile->assign(reached.index(), m_count);
      m_planes[key] = m_count;
    }
    ++m_count;
  }

  /** \return whether it may be a plane */
  bool flood(const Key& seed, const Plane& plane, double tolerance, PlaneMoments& moments)
  {
    m_reached.clear();
    std::map<Key, bool> seen;
    const auto reach = [&](const Key& key)
    {
      const auto found = m_heights.find(key);
      if (found == m_heights.end() || m_planes.count(key) || seen[key]) return;
      if (std::abs(found->second - plane.at(key.second, key.first)) > tolerance) return;
      seen[key] = true;
      m_reached.push_back(key);
    };
    reach(seed);
    moments = PlaneMoments(seed.second, seed.first, m_heights.at(seed));
    for (std::size_t i = 0; i < m_reached.size(); ++i)
    {
      const auto [y, x] = m_reached[i];
      moments.add(x, y, m_heights.at({y, x}));
      reach({y, x + 1});
      reach({y, x - 1});
      reach({y + 1, x});
      reach({y - 1, x});
    }
    return static_cast<std::int32_t>(m_reached.size()) >= m_search.minCells && moments.spans() &&
           isAllowed(moments.fit(), m_search);
  }

  PlaneSearch m_search;
  Heights m_heights;
  TileMap m_tiles;
  std::map<Key, int> m_planes;
  std::vector<Key> m_reached;
  int m_count = 0;
};
}  // namespace

TEST(PlaneGrowth, IsThatOfOneSeedAfterTheOther)
{
  for (unsigned seed = 1; seed <= 30; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const PlaneSearch how = search(random);
    const Heights map = heights(random);
    const auto wanted = SlowGrowth(how, map).grow();
    for (const int threads : {1, 2})
    {
      TileMap tiles;
      for (const auto& [key, z] : map) test::putCell(tiles, key.second, key.first, z);
      PlaneSet planes;
      PlaneGrowth(how, tiles).grow(test::allCells(tiles), planes, threads);
      std::map<Key, int> found;
      for (const auto& entry : map)
      {
        const CellRef cell = tiles.cell(entry.first.second, entry.first.first);
        const std::int32_t plane = cell.tile->plane[cell.index()];
        if (plane != kNoPlane) found[entry.first] = plane;
      }
      EXPECT_TRUE(found == wanted) << found.size() << " cells, not " << wanted.size();
    }
  }
}
