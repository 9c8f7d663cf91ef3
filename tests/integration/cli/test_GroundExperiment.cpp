#include <gtest/gtest.h>

#include <fstream>

#include "ExperimentFiles.h"

using namespace mrpt_mapconv::testing;

namespace
{
const std::string kIni = kConfig + "experiments/ground.ini";

/** A complete file of one world. */
const std::string kSmall =
    "[experiment]\nkind = ground\njudged = a\n[filter.a]\ngroundFilter = smrf\n"
    "[world.w]\nfile = " +
    kConfig + "worlds/ground_gentle.ini\ntypeI = 0.5\ntypeII = 0.5\n";

std::string errorWith(const std::string& from, const std::string& to)
{
  const TempDir dir;
  return experimentError(dir, replaced(kSmall, from, to));
}
}  // namespace

TEST(GroundExperiment, ComparesFiltersInForests)
{
  const TempDir dir;
  const Outcome outcome = mapconv({"experiment", kIni, "-o", dir.path("out"), "--quick"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  const auto points = tableRows(dir.path("out/ground_points.csv"));
  const auto maps = tableRows(dir.path("out/ground_maps.csv"));
  ASSERT_EQ(10u, points.size());  // a header, three worlds by three filters
  ASSERT_EQ(10u, maps.size());
  for (const std::string world : {"gentle", "steep", "steps"})
  {
    for (const std::string filter : {"csf", "csf_nearest", "smrf"})
    {
      const Row row = rowWith(points, {world, filter});
      EXPECT_GT(number(row, 2), 60000) << world;  // points of every tenth scan
      EXPECT_GT(number(row, 3), 1.5) << world;    // per cent of ground
      EXPECT_GT(number(rowWith(maps, {world, filter}), 2), 0) << world;
      EXPECT_EQ("\x89PNG",
                readBytes(dir.path("out/" + world + "_" + filter + ".png")).substr(0, 4));
    }
    EXPECT_TRUE(contains(rowWith(points, {world, "csf"}).at(9), "%: ")) << world;
    EXPECT_EQ("", rowWith(points, {world, "smrf"}).at(9)) << "a target is for one filter";
  }
}

TEST(GroundExperiment, SamplesThatAreNotThereAreLeftOut)
{
  const TempDir dir;
  std::ofstream(dir.path("e.ini")) << kSmall << "[sample.x]\nfile = no.pcd\nground = nowhere.pcd\n";
  const Outcome outcome =
      mapconv({"experiment", dir.path("e.ini"), "-o", dir.path("out"), "--quick"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "no.pcd")) << outcome.out;
  EXPECT_FALSE(std::filesystem::exists(dir.path("out/ground_samples.csv")));
}

TEST(GroundExperiment, SamplesAreClassifiedByAllFilters)
{
  const TempDir dir;
  {
    std::ofstream all(dir.path("all.xyz")), ground(dir.path("ground.xyz"));
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x)
      {
        all << x << ' ' << y << " 0\n";
        ground << x << ' ' << y << " 0\n";
        if (x == 10 && y > 5 && y < 9) all << x << ' ' << y << " 5\n";
      }
  }
  std::ofstream(dir.path("e.ini")) << kSmall << "[sample.x]\nfile = all.xyz\nground = ground.xyz\n";
  ASSERT_EQ(0, mapconv({"experiment", dir.path("e.ini"), "-o", dir.path("out"), "--quick"}).status);
  const Row row = rowWith(tableRows(dir.path("out/ground_samples.csv")), {"x", "a"});
  EXPECT_EQ(403, number(row, 2));
  EXPECT_EQ("99.3 %", row.at(3));
  for (const std::size_t error : {4u, 5u, 6u}) EXPECT_EQ("0.0 %", row.at(error));
  EXPECT_EQ("100.0 %", row.at(7));
}

TEST(GroundExperiment, BadSettingsAreNamed)
{
  EXPECT_TRUE(contains(errorWith("judged = a", "judged = b"), "judged = 'b'"));
  EXPECT_TRUE(contains(errorWith("judged = a", "judged = a\nthreads = -1"), "threads = '-1'"));
  EXPECT_TRUE(contains(errorWith("judged = a", "judged = a\nspeed = 1"), "speed"));
  EXPECT_TRUE(contains(errorWith("typeI = 0.5", "typeI = 5"), "typeI = '5'"));
  EXPECT_TRUE(contains(errorWith("typeII = 0.5", ""), "typeII = SHARE is missing"));
  EXPECT_TRUE(contains(errorWith("typeII = 0.5", "typeII = 0.5\nx = 1"), "'x'"));
  EXPECT_TRUE(contains(errorWith("groundFilter = smrf", "groundFilter = pmf"), "'pmf'"));
  EXPECT_TRUE(contains(errorWith("groundFilter = smrf", "smrfCell = -1"), "smrfCell"));
  EXPECT_TRUE(contains(errorWith("groundFilter = smrf", "cloth = 1"), "'cloth'"));
  EXPECT_TRUE(contains(errorWith("[world.w]", "[forest.w]"), "section 'forest.w'"));
  EXPECT_TRUE(contains(errorWith("[world.w]", "[sample.w]\nground = x\n[world.w]"),
                       "section 'sample.w': file = FILE is missing"));
  EXPECT_TRUE(contains(errorWith("[world.w]", "[sample.w]\nfile = x\n[world.w]"),
                       "section 'sample.w': ground = FILE is missing"));
  EXPECT_TRUE(contains(errorWith("ground_gentle.ini", "none.ini"), "none.ini"));
  const TempDir dir;
  EXPECT_TRUE(contains(experimentError(dir, kSmall.substr(0, kSmall.find("[world.w]"))),
                       "a section world.NAME"));
}
