// The ground below random clouds is the same for any number of threads, and any order of points.
#include <gtest/gtest.h>
#include <mrpt_mapconv/aerial/Ground.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

#include "RandomCloud.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using aerial::Ground;
using aerial::GroundFilter;
using aerial::GroundParams;

GroundParams randomParams(Rng& rng, GroundFilter filter)
{
  GroundParams params;
  params.groundFilter = filter;
  params.rigidness = pick(rng, 1, 3);
  params.slopeSmoothing = chance(rng, 80);
  params.clothResolution = uniform(rng, 0.3, 0.4);
  params.smoothingReach = params.clothResolution * uniform(rng, 1, 5);
  return params;
}

void expectSame(const Ground& a, const Ground& b)
{
  EXPECT_EQ(a.classification, b.classification);
  const auto left = aerial::styled(a.layers), right = aerial::styled(b.layers);
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    const auto& cells = left[i].layer->cells();
    ASSERT_EQ(left[i].layer->frame(), right[i].layer->frame());
    EXPECT_EQ(std::memcmp(cells.data(), right[i].layer->cells().data(), cells.size() * 4), 0)
        << left[i].name;
  }
}

/** The points in another order. */
cloud::PointCloud inOrder(const cloud::PointCloud& cloud, const std::vector<std::size_t>& order)
{
  cloud::PointCloud sorted;
  for (const std::size_t i : order)
  {
    sorted.x.push_back(cloud.x[i]);
    sorted.y.push_back(cloud.y[i]);
    sorted.z.push_back(cloud.z[i]);
  }
  return sorted;
}
}  // namespace

TEST(GroundThreads, AnyNumberOfThreadsGivesTheSameGround)
{
  for (unsigned seed = 1; seed <= 2; ++seed)
    for (const auto filter : {GroundFilter::Csf, GroundFilter::Smrf})
    {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Rng rng(seed);
      // so wide that the cloth is worth several threads
      const auto cloud = randomCloud(rng, 8000, 130);
      const auto params = randomParams(rng, filter);
      const Ground one = aerial::findGround(cloud, params, 1);
      for (const int threads : {2, 3}) expectSame(aerial::findGround(cloud, params, threads), one);
    }
}

TEST(GroundThreads, AnyOrderOfPointsGivesTheSameGround)
{
  for (unsigned seed = 1; seed <= 6; ++seed)
    for (const auto filter : {GroundFilter::Csf, GroundFilter::Smrf})
    {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Rng rng(seed);
      const auto cloud = randomCloud(rng, 3000, 40);
      const auto params = randomParams(rng, filter);
      const Ground ground = aerial::findGround(cloud, params, 1);
      std::vector<std::size_t> order(cloud.size());
      std::iota(order.begin(), order.end(), std::size_t{0});
      for (std::size_t i = order.size() - 1; i > 0; --i)
        std::swap(order[i], order[static_cast<std::size_t>(pick(rng, 0, static_cast<int>(i)))]);
      Ground shuffled = aerial::findGround(inOrder(cloud, order), params, 1);
      const auto classes = shuffled.classification;
      for (std::size_t i = 0; i < order.size(); ++i) shuffled.classification[order[i]] = classes[i];
      expectSame(shuffled, ground);
    }
}
