#include "TerrainChecks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

namespace mrpt_mapconv::test
{
namespace
{
constexpr double kEverywhere = 1e9;  // [m]

/** The cells of a plane, and their least-squares plane by the book. */
class CellsOfPlane
{
 public:
  void add(double x, double y, double z) { m_points.push_back({x, y, z}); }
  std::size_t size() const { return m_points.size(); }

  void expectFittedBy(const terrain::TerrainPlane& plane) const
  {
    const auto n = static_cast<double>(size());
    const double x = mean(0), y = mean(1), z = mean(2);
    const double xx = moment(0, 0), xy = moment(0, 1), yy = moment(1, 1), det = xx * yy - xy * xy;
    EXPECT_NEAR(plane.x, x, 1e-9 * (1 + std::abs(x)));
    EXPECT_NEAR(plane.y, y, 1e-9 * (1 + std::abs(y)));
    EXPECT_NEAR(plane.z, z, 1e-7);
    EXPECT_NEAR(plane.slopeX, (moment(0, 2) * yy - moment(1, 2) * xy) / det, 1e-6);
    EXPECT_NEAR(plane.slopeY, (moment(1, 2) * xx - moment(0, 2) * xy) / det, 1e-6);
    double squares = 0;
    for (const auto& p : m_points) squares += std::pow(p[2] - plane.heightAt(p[0], p[1]), 2);
    EXPECT_NEAR(plane.rms, std::sqrt(squares / n), 1e-6);
  }
  void expectWithin(const terrain::TerrainPlane& plane, double resolution) const
  {
    const auto range = [&](std::size_t axis, bool most)
    {
      const auto ends =
          std::minmax_element(m_points.begin(), m_points.end(),
                              [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
      return most ? (*ends.second)[axis] + resolution / 2 : (*ends.first)[axis] - resolution / 2;
    };
    EXPECT_NEAR(plane.xMin, range(0, false), 1e-6);
    EXPECT_NEAR(plane.yMin, range(1, false), 1e-6);
    EXPECT_NEAR(plane.xMax, range(0, true), 1e-6);
    EXPECT_NEAR(plane.yMax, range(1, true), 1e-6);
  }

 private:
  double mean(std::size_t axis) const
  {
    double sum = 0;
    for (const auto& p : m_points) sum += p[axis];
    return sum / static_cast<double>(size());
  }
  double moment(std::size_t a, std::size_t b) const
  {
    const double meanA = mean(a), meanB = mean(b);
    double sum = 0;
    for (const auto& p : m_points) sum += (p[a] - meanA) * (p[b] - meanB);
    return sum;
  }

  std::vector<std::array<double, 3>> m_points;
};

void expectLeaves(const terrain::TerrainMap& map, const oracle::TerrainLabels& planes)
{
  const auto leaves = map.leavesIn(-kEverywhere, -kEverywhere, kEverywhere, kEverywhere);
  const auto wanted = oracle::leavesOf(planes);
  EXPECT_EQ(map.leaves(), wanted.size());
  ASSERT_EQ(leaves.size(), wanted.size());
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const auto& leaf = leaves[i];
    const oracle::TerrainSquare square{leaf.x, leaf.y, leaf.side, leaf.plane};
    ASSERT_TRUE(square == wanted[i]) << "leaf " << i << " at (" << leaf.x << ", " << leaf.y << ")";
  }
}
}  // namespace

std::string differences(const oracle::TerrainLabels& found, const oracle::TerrainLabels& wanted)
{
  std::string text;
  int count = 0;
  for (const auto& [key, plane] : wanted)
  {
    const auto at = found.find(key);
    if (at != found.end() && at->second == plane) continue;
    if (++count > 8) continue;
    text += " (" + std::to_string(key.second) + ", " + std::to_string(key.first) +
            "): " + (at == found.end() ? "unknown" : std::to_string(at->second)) + ", not " +
            std::to_string(plane) + ";";
  }
  return std::to_string(count) + " of " + std::to_string(wanted.size()) + " cells differ:" + text;
}

void expectPartition(const terrain::TerrainMap& map, const oracle::TerrainLabels& planes,
                     const std::string& what)
{
  SCOPED_TRACE(what);
  const auto found = oracle::planesOfCells(map);
  EXPECT_TRUE(found == planes) << differences(found, planes);
  expectLeaves(map, found);
}

void expectSameMap(const terrain::TerrainMap& map, const terrain::TerrainMap& wanted)
{
  const auto found = oracle::planesOfCells(map), planes = oracle::planesOfCells(wanted);
  EXPECT_TRUE(found == planes) << differences(found, planes);
  ASSERT_EQ(map.planes().size(), wanted.planes().size());
  for (std::size_t i = 0; i < map.planes().size(); ++i)
  {
    const auto numbers = [](const terrain::TerrainPlane& p)
    {
      return std::make_tuple(p.cells, p.slopeX, p.slopeY, p.x, p.y, p.z, p.rms, p.xMin, p.yMin,
                             p.xMax, p.yMax, p.firstX, p.firstY);
    };
    EXPECT_EQ(map.planes()[i].cells, wanted.planes()[i].cells);
    EXPECT_TRUE(numbers(map.planes()[i]) == numbers(wanted.planes()[i])) << "plane " << i;
  }
  EXPECT_EQ(map.leaves(), wanted.leaves());
}

void expectInvariants(const terrain::TerrainMap& map)
{
  const auto planes = oracle::planesOfCells(map);
  EXPECT_EQ(planes.size(), map.cells());
  const auto parts = oracle::connectedParts(planes);
  EXPECT_TRUE(parts == planes) << "not connected, or not in order: " << differences(planes, parts);
  std::vector<CellsOfPlane> cells(map.planes().size());
  for (const auto& [key, plane] : planes)
  {
    if (plane < 0) continue;
    ASSERT_LT(static_cast<std::size_t>(plane), cells.size());
    cells[static_cast<std::size_t>(plane)].add(key.second * map.resolution(),
                                               key.first * map.resolution(),
                                               map.cell(key.second, key.first)->height);
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    SCOPED_TRACE("plane " + std::to_string(i));
    const terrain::TerrainPlane& plane = map.planes()[i];
    ASSERT_EQ(static_cast<std::size_t>(plane.cells), cells[i].size());
    EXPECT_GE(plane.cells, map.params().minPlaneCells);
    cells[i].expectFittedBy(plane);
    cells[i].expectWithin(plane, map.resolution());
    EXPECT_EQ(planes.at({plane.firstY, plane.firstX}), static_cast<int>(i));
  }
  expectLeaves(map, planes);
}

}  // namespace mrpt_mapconv::test
