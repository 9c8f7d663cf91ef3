// Ground robots' paths are lifted on the support, which may lie above or below the floor.
#include <gtest/gtest.h>
#include <mrpt_mapconv/path/LiftPath.h>

#include <cmath>

#include "FlatLayers.h"
#include "support/SeenGround.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::path;
namespace evidence = freespace::evidence;
using test::ground;
using test::sphere;
using test::withSeenGround;

/** Cells of 0.25 m on one level; those with 1 m ≤ x < 1.5 m are open, with a floor and perhaps a
 * support elsewhere. */
freespace::Layers layersWithGap(float floor, float support)
{
  auto layers = withSeenGround(test::flatLayers());
  for (int iy = 0; iy < layers.frame().height; ++iy)
    for (int ix = 4; ix < 6; ++ix)
    {
      layers.floor.at(ix, iy) = floor;
      layers.support.at(ix, iy) = support;
      layers.evidence.at(ix, iy) = std::isnan(support) ? evidence::kOpen : evidence::kInferred;
    }
  return layers;
}

const std::vector<mrpt::math::TPoint2D> kAcross{{0.625, 1.125}, {2.125, 1.125}};

TEST(LiftPathSupport, HeightsAreThoseOfTheSupport)
{
  const LiftedPath low = liftPath(kAcross, layersWithGap(0.75f, 0.125f), {}, ground(0.5, 0));
  const LiftedPath high = liftPath(kAcross, layersWithGap(-0.5f, 0.125f), {}, ground(0.5, 0));
  ASSERT_EQ(low.points.size(), 7u);
  const double z[] = {0.5, 0.5, 0.625, 0.625, 0.5, 0.5, 0.5};
  for (std::size_t i = 0; i < 7; ++i)
  {
    EXPECT_EQ(low.points[i].position.z, z[i]) << i;
    EXPECT_EQ(high.points[i].position.z, z[i]) << i;
  }
}

TEST(LiftPathSupport, AFlyingRobotKeepsToTheFloor)
{
  const auto heights = [](float support)
  {
    std::vector<double> z;
    for (const LiftedPoint& point :
         liftPath(kAcross, layersWithGap(0.75f, support), {}, sphere(0.5, 0.5)).points)
      z.push_back(point.position.z);
    return z;
  };
  EXPECT_EQ(heights(0.125f), heights(0.75f));
  EXPECT_EQ(heights(0.125f), heights(freespace::Layers::kNone));
  EXPECT_EQ(heights(0.125f).at(2), 1.25);
}

TEST(LiftPathSupport, WhereNobodySawTheGroundIsNoWay)
{
  const auto layers = layersWithGap(0.75f, freespace::Layers::kNone);
  const LiftedPath path = liftPath(kAcross, layers, {}, ground(0.5, 0.5));
  EXPECT_EQ(path.firstProblem(), 2u);
  EXPECT_EQ(path.points.at(2).problem, Infeasibility::UnseenGround);
  EXPECT_EQ(path.describeProblem(2),
            "point 2 at (1.12, 1.12): nobody saw the ground there, and none that was seen around "
            "tells where it is");
  EXPECT_EQ(path.points.at(4).problem, Infeasibility::None);
  EXPECT_EQ(path.points.at(1).position.z, 0.5) << "a floor that is none is not looked ahead for";
}

TEST(LiftPathSupport, TheInferredLengthIsThatOfTheWayInInferredCells)
{
  const auto layers = layersWithGap(0.75f, 0.125f);
  const auto inferred =
      [&](const std::vector<mrpt::math::TPoint2D>& path, const LiftParams& params = ground(0, 0))
  { return liftPath(path, layers, {}, params).inferredLength; };
  EXPECT_NEAR(inferred(kAcross), 0.5, 1e-12);
  EXPECT_NEAR(inferred({{1.375, 1.125}, {2.125, 1.125}}), 0.125, 1e-12);
  EXPECT_NEAR(inferred({{0.5, 0.5}, {2, 2}}), 0.5 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(inferred({{0.5, 1.125}, {2, 1.125}, {0.5, 1.125}}), 1, 1e-12) << "there and back";
  EXPECT_NEAR(inferred({{1, 0.5}, {1, 1.5}}), 1, 1e-12) << "the border belongs to the cells behind";
  EXPECT_EQ(inferred({{1.5, 0.5}, {1.5, 1.5}}), 0);
  EXPECT_EQ(inferred({{1.125, 1.125}}), 0);
  EXPECT_EQ(inferred(kAcross, sphere(0.5)), 0) << "it does not stand on it";
}

}  // namespace
