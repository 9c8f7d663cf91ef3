// Layers that follow a changing map against converting the whole map anew.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelGridSource.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <string>

#include "CompareLayers.h"
#include "FailingSource.h"
#include "MapEditor.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using Source = voxel::OctreeSource<octomap::OcTree>;

freespace::ConversionParams randomParams(Rng& rng, double res)
{
  auto params = freespace::ConversionParams::paper();
  params.minClearance = pick(rng, 0, 8) * res;
  params.minOccupancy = chance(rng, 50) ? 0.25 * pick(rng, 0, 4) : uniform(rng, 0, 1);
  params.slopeWindow = chance(rng, 90) ? pick(rng, 1, 6) : 40;
  params.maxSlope = uniform(rng, 0, 3);
  params.maxStep = chance(rng, 50) ? pick(rng, 1, 5) * res : 0;
  if (chance(rng, 20)) params.maxStep.reset();
  if (chance(rng, 30)) params.reading.unknown = voxel::Unknown::Free;
  if (chance(rng, 50)) params.floorFrom = freespace::FloorFrom::Seen;
  params.maxGap = pick(rng, 0, 30) * res;
  params.maxHiddenGap = pick(rng, 0, 10) * res;
  return params;
}

/** The changed columns, sometimes with others around them or anywhere. */
voxel::ColumnSet announced(Rng& rng, const voxel::ColumnSet& changed)
{
  if (chance(rng, 60) || changed.empty()) return changed;
  voxel::ColumnSet superset = chance(rng, 50) ? changed.dilated(pick(rng, 1, 3)) : changed;
  const grid::GridFrame around = changed.bounds(1.0);
  for (int i = pick(rng, 0, 20); i > 0; --i)
    superset.insert(pick(rng, around.x0 - 12, around.xEnd() + 12),
                    pick(rng, around.y0 - 12, around.yEnd() + 12));
  return superset;
}

/** Layers against full conversions of the same map, on every frame. */
void expectFollows(const freespace::IncrementalLayers& followed, const Source& source)
{
  freespace::Layers full;
  if (source.bounds()) full = freespace::convert(source, followed.params(), 1);
  EXPECT_TRUE(isPaddedWith(followed.layers(), full));
  EXPECT_TRUE(sameBits(followed.exact(source), full));
  freespace::IncrementalLayers anew(followed.params(), 1);
  anew.rebuild(source, followed.layers().frame());
  EXPECT_TRUE(sameBits(followed.layers(), anew.layers()));
}

/** Only the cells that are said to may have other values than before. */
void expectOthersAsBefore(const freespace::Layers& before,
                          const freespace::IncrementalLayers& followed,
                          const voxel::ColumnSet& reached)
{
  const grid::GridFrame& frame = before.frame();
  freespace::Layers others = followed.layers();
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
      if (reached.contains(frame.x0 + ix, frame.y0 + iy))
        for (const auto& entry : freespace::Layers::list())
          (others.*entry.member).at(ix, iy) = (before.*entry.member).at(ix, iy);
  EXPECT_TRUE(sameBits(others, before));
}

TEST(Incremental, RandomEditsEqualFullConversions)
{
  constexpr double kResolutions[] = {0.05, 0.07, 0.1, 0.3};
  for (unsigned seed = 1; seed <= 120 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    const double res = kResolutions[seed % 4];
    const int origins[] = {-150, -50, -31, 0, 29900, -30050};
    const int x0 = origins[pick(rng, 0, 5)], y0 = origins[pick(rng, 0, 5)];
    MapEditor editor(rng, res, x0, y0, pick(rng, -100, 100));
    const Source source(editor.tree());
    const freespace::ConversionParams params = randomParams(rng, res);
    freespace::IncrementalLayers one(params, 1), two(params, 2), ofBricks(params, 1);
    const voxel::ColumnSet everything = voxel::ColumnSet::of(freespace::frameOf(source));
    one.update(source, everything);
    two.rebuild(source);
    const voxel::VoxelGrid first = voxel::toVoxelGrid(editor.tree());
    ofBricks.update(voxel::VoxelGridSource(first), everything);
    expectFollows(one, source);
    expectFollows(two, source);
    for (int step = 1; step <= 30 && !HasFailure(); ++step)
    {
      const voxel::ColumnSet changed = announced(rng, editor.edit());
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step) + ": " +
                   editor.lastEdit() + "; " + text(params));
      const grid::GridFrame before = one.layers().frame();
      const freespace::Layers layersBefore = one.layers();
      const freespace::LayersChange change = one.update(source, changed);
      if (one.layers().frame() != before)
        EXPECT_TRUE(change.everywhere);
      else if (!change.everywhere)
        expectOthersAsBefore(layersBefore, one, change.columns);
      expectFollows(one, source);
      two.update(source, changed);
      expectFollows(two, source);
      const voxel::VoxelGrid bricks = voxel::toVoxelGrid(editor.tree());
      ofBricks.update(voxel::VoxelGridSource(bricks), changed);
      EXPECT_TRUE(sameBits(one.layers(), ofBricks.layers()));
    }
  }
}

/** Whoever forgets everything can begin again with a map that was there before. */
TEST(Incremental, ClearedLayersFollowAgain)
{
  Rng rng(7);
  MapEditor editor(rng, 0.1, -31, 4, 0);
  const Source source(editor.tree());
  freespace::IncrementalLayers followed(freespace::ConversionParams::paper(), 1);
  followed.rebuild(source);
  followed.clear();
  EXPECT_TRUE(followed.layers().frame().empty());
  followed.update(source, voxel::ColumnSet::of(freespace::frameOf(source)));
  EXPECT_FALSE(followed.layers().frame().empty());
  expectFollows(followed, source);
}

struct Direction
{
  const char* name;
  int dx, dy;
};

TEST(Incremental, LayingOutAnewStaysRareInAGrowingMap)
{
  for (const Direction d : {Direction{"east", 1, 0},
                            {"west", -1, 0},
                            {"north", 0, 1},
                            {"south", 0, -1},
                            {"south-west", -1, -1}})
  {
    SCOPED_TRACE(d.name);
    octomap::OcTree tree(0.1);
    const Source source(tree);
    freespace::IncrementalLayers followed(freespace::ConversionParams::paper(), 1);
    int relayouts = 0;
    for (int step = 0; step < 1000; ++step)
    {
      const int kx = 5 + step * d.dx, ky = -3 + step * d.dy;
      for (int kz = 0; kz < 12; ++kz)
        tree.setNodeValue(oracle::octomapKey(kx, ky, kz), kz == 0 ? 0.85f : -0.4f, true);
      voxel::ColumnSet changed;
      changed.insert(kx, ky);
      if (followed.update(source, changed).everywhere) ++relayouts;
    }
    // by half each time: log(1000)/log(1.5) = 17 at most, plus the first few single cells
    EXPECT_LE(relayouts, 20);
    EXPECT_GE(relayouts, 1);
    expectFollows(followed, source);
  }
}

/** Edits of one kind at a time, each a few scattered columns on both sides of block borders: only
 * ceilings change, only walls, only floors (of which many lie beside unknown columns), or all. */
TEST(Incremental, EditsOfOneKind)
{
  enum Kind
  {
    Ceilings,
    Walls,
    Floors,
    Kinds
  };
  for (unsigned seed = 1; seed <= 24 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    octomap::OcTree tree(0.1);
    const auto mark = [&](int kx, int ky, int kz, bool occupied)
    { tree.setNodeValue(oracle::octomapKey(kx, ky, kz), occupied ? 0.85f : -0.4f); };
    const auto isWall = [](int kx, int ky) { return (kx + 3 * ky) % 7 == 0; };
    for (int ky = -36; ky < 36; ++ky)
      for (int kx = -36; kx < 36; ++kx)
        for (int kz = 0; kz < 24 && (kx * kx + ky) % 5 != 0; ++kz)
          mark(kx, ky, kz, isWall(kx, ky) ? chance(rng, 70) : kz == 0 || kz == 23);
    const Source source(tree);
    freespace::ConversionParams params = randomParams(rng, 0.1);
    params.minClearance = 0.4;
    freespace::IncrementalLayers followed(params, 1 + static_cast<int>(seed % 2));
    followed.rebuild(source);
    for (int step = 0; step < 12 && !HasFailure(); ++step)
    {
      const int kind = pick(rng, 0, Kinds);
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step) + ", kind " +
                   std::to_string(kind) + "; " + text(params));
      voxel::ColumnSet changed;
      for (int i = pick(rng, 1, 40); i > 0; --i)
      {
        const int border = 32 * pick(rng, -1, 1);
        const int kx = border + pick(rng, -2, 1), ky = pick(rng, -36, 35);
        if (kx < -36 || kx > 35 || (kind == Walls) != isWall(kx, ky)) continue;
        const bool low = kind == Floors || (kind == Kinds && chance(rng, 50));
        const int kz = kind == Walls ? pick(rng, 0, 23) : low ? pick(rng, 0, 4) : pick(rng, 18, 23);
        mark(kx, ky, kz, chance(rng, 50));
        changed.insert(kx, ky);
      }
      followed.update(source, changed);
      expectFollows(followed, source);
    }
  }
}

/** A voxel source that keeps account of the columns that are asked for. */
class WatchedSource : public voxel::VoxelSource
{
 public:
  explicit WatchedSource(const voxel::VoxelSource& source) : m_source(source) {}
  double resolution() const override { return m_source.resolution(); }
  std::optional<voxel::KeyRect> bounds() const override { return m_source.bounds(); }
  void read(voxel::ColumnBlock& block) const override
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      for (int y = 0; y < voxel::kBlockSide; ++y)
        for (int x = 0; x < voxel::kBlockSide; ++x)
          if (block.wanted()[static_cast<std::size_t>(y)] >> x & 1u)
            m_asked.insert(block.key().x * voxel::kBlockSide + x,
                           block.key().y * voxel::kBlockSide + y);
    }
    m_source.read(block);
  }
  voxel::ColumnSet& asked() const { return m_asked; }

 private:
  const voxel::VoxelSource& m_source;
  mutable std::mutex m_mutex;
  mutable voxel::ColumnSet m_asked;
};

/** Only the changed columns and the ring whose occupancy depends on them are read. */
TEST(Incremental, ReadsOnlyWhatDependsOnTheChange)
{
  Rng rng(3);
  octomap::OcTree tree(0.1);
  for (int ky = -40; ky < 40; ++ky)
    for (int kx = -40; kx < 40; ++kx)
      for (int kz = 0; kz < 12; ++kz)
        tree.setNodeValue(oracle::octomapKey(kx, ky, kz), kz == 0 || chance(rng, 1) ? 0.85f : -0.4f,
                          true);
  const Source source(tree);
  const WatchedSource watched(source);
  auto params = freespace::ConversionParams::paper();
  params.slopeWindow = 5;
  freespace::IncrementalLayers followed(params, 2);
  followed.rebuild(watched);
  for (int step = 0; step < 20; ++step)
  {
    watched.asked().clear();
    voxel::ColumnSet changed;
    for (int i = 0; i < 3; ++i)
    {
      const int kx = pick(rng, -40, 39), ky = pick(rng, -40, 39);
      tree.setNodeValue(oracle::octomapKey(kx, ky, pick(rng, 1, 11)), 0.85f);
      changed.insert(kx, ky);
    }
    EXPECT_FALSE(followed.update(watched, changed).everywhere);
    const voxel::ColumnSet allowed = changed.dilated(1);
    for (int ky = -64; ky < 64; ++ky)
      for (int kx = -64; kx < 64; ++kx)
      {
        EXPECT_TRUE(!watched.asked().contains(kx, ky) || allowed.contains(kx, ky))
            << "column (" << kx << ", " << ky << ") in step " << step;
        EXPECT_TRUE(!changed.contains(kx, ky) || watched.asked().contains(kx, ky))
            << "column (" << kx << ", " << ky << ") in step " << step;
      }
    expectFollows(followed, source);
  }
}

/** A hall of 20 × 20 free columns of 1 m above a floor, with a wall of one column at (5, 5). */
void makeHall(octomap::OcTree& tree)
{
  for (int ky = 0; ky < 20; ++ky)
    for (int kx = 0; kx < 20; ++kx)
      for (int kz = 0; kz < 12; ++kz)
      {
        const bool solid = kz == 0 || kz == 11 || (kx == 5 && ky == 5);
        tree.setNodeValue(oracle::octomapKey(kx, ky, kz), solid ? 0.85f : -0.4f, true);
      }
}

std::size_t readFor(WatchedSource& watched, freespace::IncrementalLayers& followed,
                    const voxel::ColumnSet& changed)
{
  watched.asked().clear();
  followed.update(watched, changed);
  return watched.asked().size();
}

/** Beyond the changed columns only those without a floor beside a new free span are read. */
TEST(Incremental, ReadsNoColumnThatCannotChange)
{
  octomap::OcTree tree(0.1);
  makeHall(tree);
  const Source source(tree);
  WatchedSource watched(source);
  freespace::IncrementalLayers followed(freespace::ConversionParams::paper(), 1);
  followed.rebuild(watched);
  const auto only = [](int kx, int ky)
  {
    voxel::ColumnSet set;
    set.insert(kx, ky);
    return set;
  };
  EXPECT_EQ(readFor(watched, followed, only(4, 5)), 1u) << "announced, but nothing has changed";
  tree.setNodeValue(oracle::octomapKey(10, 10, 11), -0.4f);
  EXPECT_EQ(readFor(watched, followed, only(10, 10)), 1u) << "a ceiling, far from any wall";
  expectFollows(followed, source);
  tree.setNodeValue(oracle::octomapKey(4, 5, 11), -0.4f);
  EXPECT_EQ(readFor(watched, followed, only(4, 5)), 2u) << "a ceiling beside the wall at (5, 5)";
  EXPECT_TRUE(watched.asked().contains(5, 5));
  expectFollows(followed, source);
}

/** What an update that failed has left undone is done by the next one. */
TEST(Incremental, AFailedUpdateIsMadeUpFor)
{
  for (unsigned seed = 1; seed <= 30 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    MapEditor editor(rng, 0.1, pick(rng, -60, 60), pick(rng, -60, 60), 0);
    const Source source(editor.tree());
    FailingSource failing(source);
    freespace::IncrementalLayers followed(randomParams(rng, 0.1), 1);
    followed.rebuild(failing);
    voxel::ColumnSet changed;
    for (int i = 0; i < 5; ++i) changed.insert(editor.edit());
    const bool failed =
        failing.failsIn(pick(rng, 0, 3), [&] { followed.update(failing, changed); });
    followed.update(failing, failed ? voxel::ColumnSet() : changed);
    expectFollows(followed, source);
  }
}

}  // namespace
