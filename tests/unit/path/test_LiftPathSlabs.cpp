// Lifting with the voxel map: slabs between two free ranges, and which columns are read.
#include <gtest/gtest.h>
#include <mrpt_mapconv/path/LiftPath.h>

#include <cmath>
#include <stdexcept>

#include "FlatLayers.h"
#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::path;
using test::HandMap;
using test::sphere;

constexpr int kLintel = 6;  // x 1.5 … 1.75 m

/** Cells of 0.25 m, x 0 … 3 m, y 0 … 2.5 m, free from 0 to 4 m; over the whole width hangs a lintel
 * from 1.5 to 2 m, free above. */
class LintelMap : public HandMap
{
 public:
  LintelMap() : HandMap(0.25)
  {
    for (int kx = 0; kx < 12; ++kx)
      for (int ky = 0; ky < 10; ++ky)
      {
        free(kx, ky, 0, 16);
        if (kx == kLintel) occupied(kx, ky, 6, 8);
      }
    layers = convert(freespace::ConversionParams::paper());
  }
  LiftedPoint lift(double x, const LiftParams& params, bool withVoxels = true) const
  {
    const LiftedPath lifted =
        liftPath({{x, 1.125}}, layers, {}, params, withVoxels ? &source() : nullptr);
    EXPECT_EQ(lifted.slabsChecked, withVoxels);
    return lifted.points.at(0);
  }

  freespace::Layers layers;
};

TEST(LiftPathSlabs, UnderALintel)
{
  const LintelMap map;
  const LiftedPoint under = map.lift(1.625, sphere(1.5));
  EXPECT_EQ(under.position.z, 1.0);
  EXPECT_EQ(under.rule, HeightRule::SphereSlab);
  const LiftedPoint beside = map.lift(1.375, sphere(1.5));  // 0.125 m before it
  EXPECT_NEAR(beside.position.z, 1.5 - std::sqrt(0.25 - 0.015625), 1e-12);
  EXPECT_EQ(beside.rule, HeightRule::SphereSlab);
  const LiftedPoint away = map.lift(0.875, sphere(1.5));  // 0.625 m before it
  EXPECT_EQ(away.position.z, 1.5);
  EXPECT_EQ(away.rule, HeightRule::FloorAhead);
}

TEST(LiftPathSlabs, LayersAloneDoNotSeeIt)
{
  const LintelMap map;
  const LiftedPoint through = map.lift(1.625, sphere(1.5), false);
  EXPECT_EQ(through.position.z, 1.5);
  EXPECT_EQ(through.rule, HeightRule::FloorAhead);
}

TEST(LiftPathSlabs, OverItWhereThatIsNearer)
{
  const LintelMap map;
  EXPECT_EQ(map.lift(1.625, sphere(2.0)).position.z, 2.5);
  EXPECT_EQ(map.lift(1.625, sphere(1.75)).position.z, 2.5) << "as near as 1.0, and higher";
  EXPECT_EQ(map.lift(1.625, sphere(1.6875)).position.z, 1.0);
  EXPECT_EQ(map.lift(1.625, sphere(1.75)).rule, HeightRule::SphereSlab);
}

TEST(LiftPathSlabs, TouchingItIsAllowed)
{
  const LintelMap map;
  for (const double z : {0.5, 1.0, 2.5, 3.5})
  {
    EXPECT_EQ(map.lift(1.625, sphere(z)).position.z, z);
    EXPECT_EQ(map.lift(1.625, sphere(z)).rule, HeightRule::FloorAhead) << z;
  }
}

TEST(LiftPathSlabs, FloorAndCeilingStillCount)
{
  const LintelMap map;
  EXPECT_EQ(map.lift(1.625, sphere(0.25)).rule, HeightRule::SphereFloor);
  EXPECT_EQ(map.lift(1.625, sphere(0.25)).position.z, 0.5);
  EXPECT_EQ(map.lift(1.625, sphere(3.75)).rule, HeightRule::SphereCeiling);
  EXPECT_EQ(map.lift(1.625, sphere(3.75)).position.z, 3.5);
}

TEST(LiftPathSlabs, ALowRangeAboveItIsNotKept)
{
  LintelMap map;
  for (int ky = 0; ky < 10; ++ky) map.occupied(kLintel, ky, 11, 16);  // 0.75 m remain above
  map.layers = map.convert(freespace::ConversionParams::paper());
  const LiftedPoint point = map.lift(1.625, sphere(2.25));
  EXPECT_EQ(point.position.z, 1.0);
  EXPECT_EQ(point.rule, HeightRule::SphereCeiling) << "the column's only kept range ends at 1.5 m";
}

TEST(LiftPathSlabs, SlabsThatLeaveNoHeight)
{
  LintelMap map;
  // the next column's free ranges are 0 … 0.5 (too low) and 1 … 4: no z suits both below 2 m
  for (int ky = 0; ky < 10; ++ky)
  {
    map.occupied(kLintel + 1, ky, 0, 5).free(kLintel + 1, ky, 5, 9);
    map.occupied(kLintel + 1, ky, 9, 16);  // 1.25 … 2.25 m
  }
  map.layers = map.convert(freespace::ConversionParams::paper());
  EXPECT_EQ(map.lift(1.625, sphere(1)).problem, Infeasibility::NoHeight);
  EXPECT_EQ(map.lift(1.625, sphere(1), false).problem, Infeasibility::None);
}

TEST(LiftPathSlabs, GroundRobotsDoNotNeedTheVoxelMap)
{
  const LintelMap map;
  const LiftedPath lifted =
      liftPath({{1.625, 1.125}}, map.layers, {}, test::ground(1.5, 0), &map.source());
  EXPECT_FALSE(lifted.slabsChecked);
  EXPECT_EQ(lifted.points.at(0).position.z, 1.5);
}

TEST(LiftPathSlabs, RefusesAnotherVoxelMap)
{
  const auto errorWith = [](const freespace::Layers& layers, const HandMap& map)
  {
    try
    {
      liftPath({{1.625, 1.125}}, layers, {}, sphere(1), &map.source());
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const LintelMap made;
  EXPECT_EQ(errorWith(made.layers, made), "no error");

  LintelMap raised, filled;
  raised.occupied(7, 4, 0, 1);
  EXPECT_EQ(errorWith(made.layers, raised),
            "voxel map: floor and ceiling of cell (7, 4) are 0.25 and 4 m, but 0 and 4 m in the "
            "layers; it must be the map that the layers were made of");
  filled.occupied(7, 4, 0, 16);
  filled.layers = filled.convert(freespace::ConversionParams::paper());
  EXPECT_EQ(errorWith(filled.layers, made).substr(0, 66),
            "voxel map: floor and ceiling of cell (7, 4) are 0 and 4 m, but nan");
  EXPECT_EQ(errorWith(test::flatLayers(0.5), made).substr(0, 44),
            "voxel map: its resolution is 0.25 m, the lay");
  HandMap empty(0.25);
  EXPECT_NE(errorWith(made.layers, empty), "no error");
}

/** Notes what is read of another source. */
class Listener : public voxel::VoxelSource
{
 public:
  explicit Listener(const voxel::VoxelSource& source) : m_source(source) {}
  double resolution() const override { return m_source.resolution(); }
  std::optional<voxel::KeyRect> bounds() const override { return m_source.bounds(); }
  void read(voxel::ColumnBlock& block) const override
  {
    ++reads;
    for (int y = 0; y < voxel::kBlockSide; ++y)
      for (int x = 0; x < voxel::kBlockSide; ++x)
        if (block.wanted()[static_cast<std::size_t>(y)] >> x & 1u)
          columns.insert(block.key().x * voxel::kBlockSide + x,
                         block.key().y * voxel::kBlockSide + y);
    m_source.read(block);
  }

  mutable int reads = 0;
  mutable voxel::ColumnSet columns;

 private:
  const voxel::VoxelSource& m_source;
};

TEST(LiftPathSlabs, ReadsOnlyColumnsInReachAndEachBlockOnce)
{
  HandMap map(0.25);
  for (int kx = -40; kx < 40; ++kx)
    for (int ky = -3; ky < 5; ++ky) map.free(kx, ky, 0, 8);
  const freespace::Layers layers = map.convert(freespace::ConversionParams::paper());
  const Listener listener(map.source());
  LiftParams params = sphere(1);
  params.safetyRadius = 0.25;
  // to and fro over a block's corner, (0, 0)
  const LiftedPath lifted =
      liftPath({{-0.625, 0.125}, {0.625, 0.125}, {-0.625, 0.125}}, layers, {}, params, &listener);
  EXPECT_TRUE(lifted.feasible());
  EXPECT_EQ(listener.reads, 4);
  // points lie in cells −3 … 2 and reach 0.25 m: one cell on, also diagonally (d = 0.177 m)
  EXPECT_EQ(listener.columns.size(), 8u * 3u);
  for (int kx = -4; kx <= 3; ++kx)
    for (int ky = -1; ky <= 1; ++ky) EXPECT_TRUE(listener.columns.contains(kx, ky));
}

}  // namespace
