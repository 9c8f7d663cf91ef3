#include <gtest/gtest.h>

#include "StoredMaps.h"

namespace mrpt_mapconv::fixtures
{
using Grid = mrpt::maps::COccupancyGridMap2D;

namespace
{
void setInsertion(Grid::TInsertionOptions& options)
{
  options.mapAltitude = 0.75f;
  options.useMapAltitude = true;
  options.maxDistanceInsertion = 12;
  options.maxOccupancyUpdateCertainty = 0.875f;
  options.maxFreenessUpdateCertainty = 0.625f;
  options.maxFreenessInvalidRanges = 0.5625f;
  options.considerInvalidRangesAsFreeSpace = false;
  options.decimation = 3;
  options.horizontalTolerance = 0.125f;
  options.CFD_features_gaussian_size = 2;
  options.CFD_features_median_size = 5;
  options.wideningBeamsWithDistance = true;
}

void expectInsertion(const Grid::TInsertionOptions& options)
{
  EXPECT_EQ(0.75f, options.mapAltitude);
  EXPECT_TRUE(options.useMapAltitude);
  EXPECT_EQ(12, options.maxDistanceInsertion);
  EXPECT_EQ(0.875f, options.maxOccupancyUpdateCertainty);
  EXPECT_EQ(0.625f, options.maxFreenessUpdateCertainty);
  EXPECT_EQ(0.5625f, options.maxFreenessInvalidRanges);
  EXPECT_FALSE(options.considerInvalidRangesAsFreeSpace);
  EXPECT_EQ(3, options.decimation);
  EXPECT_EQ(0.125f, options.horizontalTolerance);
  EXPECT_EQ(2, options.CFD_features_gaussian_size);
  EXPECT_EQ(5, options.CFD_features_median_size);
  EXPECT_TRUE(options.wideningBeamsWithDistance);
}

void setLikelihood(Grid::TLikelihoodOptions& options)
{
  options.likelihoodMethod = Grid::lmConsensus;
  options.LF_stdHit = 0.125f;
  options.LF_zHit = 0.75f;
  options.LF_zRandom = 0.25f;
  options.LF_maxRange = 50;
  options.LF_decimation = 3;
  options.LF_maxCorrsDistance = 0.5f;
  options.LF_useSquareDist = true;
  options.LF_alternateAverageMethod = true;
  options.MI_exponent = 1.5f;
  options.MI_skip_rays = 7;
  options.MI_ratio_max_distance = 2;
  options.rayTracing_useDistanceFilter = false;
  options.rayTracing_decimation = 4;
  options.rayTracing_stdHit = 0.5f;
  options.consensus_takeEachRange = 2;
  options.consensus_pow = 3;
  options.OWA_weights = {0.5f, 0.375f, 0.125f};
  options.enableLikelihoodCache = false;
}

void expectLikelihood(const Grid::TLikelihoodOptions& options)
{
  EXPECT_EQ(Grid::lmConsensus, options.likelihoodMethod);
  EXPECT_EQ(0.125f, options.LF_stdHit);
  EXPECT_EQ(0.75f, options.LF_zHit);
  EXPECT_EQ(0.25f, options.LF_zRandom);
  EXPECT_EQ(50, options.LF_maxRange);
  EXPECT_EQ(3u, options.LF_decimation);
  EXPECT_EQ(0.5f, options.LF_maxCorrsDistance);
  EXPECT_TRUE(options.LF_useSquareDist);
  EXPECT_TRUE(options.LF_alternateAverageMethod);
  EXPECT_EQ(1.5f, options.MI_exponent);
  EXPECT_EQ(7u, options.MI_skip_rays);
  EXPECT_EQ(2, options.MI_ratio_max_distance);
  EXPECT_FALSE(options.rayTracing_useDistanceFilter);
  EXPECT_EQ(4, options.rayTracing_decimation);
  EXPECT_EQ(0.5f, options.rayTracing_stdHit);
  EXPECT_EQ(2, options.consensus_takeEachRange);
  EXPECT_EQ(3, options.consensus_pow);
  EXPECT_EQ((std::vector<float>{0.5f, 0.375f, 0.125f}), options.OWA_weights);
  EXPECT_FALSE(options.enableLikelihoodCache);
}
}  // namespace

void setGridOptions(Grid& map)
{
  setInsertion(map.insertionOptions);
  setLikelihood(map.likelihoodOptions);
  map.genericMapParams.enableSaveAs3DObject = false;
  map.genericMapParams.enableObservationLikelihood = false;
  map.genericMapParams.enableObservationInsertion = false;
}

void expectGridOptions(const Grid& map)
{
  expectInsertion(map.insertionOptions);
  expectLikelihood(map.likelihoodOptions);
  EXPECT_FALSE(map.genericMapParams.enableSaveAs3DObject);
  EXPECT_FALSE(map.genericMapParams.enableObservationLikelihood);
  EXPECT_FALSE(map.genericMapParams.enableObservationInsertion);
}

}  // namespace mrpt_mapconv::fixtures
