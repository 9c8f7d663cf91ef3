#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using Options = mrpt_mapconv::voxel::TVoxelInsertionOptions;

std::string complaintOf(const Options& options)
{
  try
  {
    options.check();
    return "";
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

struct Excluding
{
  std::vector<std::pair<double Options::*, double>> values;
  std::vector<std::string> words;
};

TEST(VoxelInsertionOptions, ValuesThatExcludeEachOtherAreErrors)
{
  const std::vector<Excluding> cases{
      {{{&Options::clampingThresMax, 0.4}},
       {"clampingThresMax = 0.4", "at least occupancyThres = 0.5", "ever be occupied"}},
      {{{&Options::occupancyThres, 0.98}},
       {"clampingThresMax = 0.971", "occupancyThres = 0.98", "ever be occupied"}},
      {{{&Options::clampingThresMin, 0.6}},
       {"clampingThresMin = 0.6", "below occupancyThres = 0.5", "ever be free"}},
      {{{&Options::clampingThresMin, 0.5}}, {"clampingThresMin = 0.5", "ever be free"}},
      {{{&Options::occupancyThres, 0.1}},
       {"clampingThresMin = 0.1192", "occupancyThres = 0.1", "ever be free"}},
      {{{&Options::probHit, 0.98}}, {"probHit = 0.98", "at most clampingThresMax = 0.971"}},
      {{{&Options::probMiss, 0.1}}, {"probMiss = 0.1", "at least clampingThresMin = 0.1192"}},
      {{{&Options::occupancyThres, 0}}, {"occupancyThres = 0 ", "above 0"}},
      {{{&Options::occupancyThres, 1}}, {"occupancyThres = 1 ", "below 1"}},
      {{{&Options::probHit, 0.5}, {&Options::occupancyThres, 0.6}},
       {"probHit = 0.5", "occupancyThres = 0.6", "ever be occupied"}},
      {{{&Options::probMiss, 0.5}}, {"probMiss = 0.5", "occupancyThres = 0.5"}},
  };
  for (const auto& [values, words] : cases)
  {
    Options options;
    for (const auto& [member, value] : values) options.*member = value;
    const std::string complaint = complaintOf(options);
    for (const auto& word : words)
      EXPECT_NE(std::string::npos, complaint.find(word)) << word << ": " << complaint;
  }
}

TEST(VoxelInsertionOptions, ValuesAtEachOthersLimitsAreGood)
{
  Options options;
  options.occupancyThres = options.clampingThresMax = options.probHit = 0.8;
  options.probMiss = options.clampingThresMin = 0.3;
  EXPECT_EQ("", complaintOf(options));
  options = {};
  options.probHit = options.clampingThresMax = 1;
  options.probMiss = options.clampingThresMin = 0;
  EXPECT_EQ("", complaintOf(options));
  options = {};
  options.probMiss = 0.5;
  options.occupancyThres = 0.6;
  EXPECT_EQ("", complaintOf(options));
}
}  // namespace
