#include <gtest/gtest.h>

#include <filesystem>

#include "OctreeFiles.h"
#include "Program.h"
#include "Raster.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

TEST(Project, givesTheHandWorkedCells)
{
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  const auto run = mapconv({"project", dir.path("hand.bt"), "--z-min", "0.5", "--z-max", "1.5",
                            "-o", dir.path("out"), "--json"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ("", run.err);
  const JsonValue json = parseJson(run.out);
  EXPECT_EQ(9, json["free"].number);
  EXPECT_EQ(3, json["occupied"].number);
  EXPECT_EQ(3, json["unknown"].number);
  EXPECT_EQ(0.5, json["zMin"].number);
  EXPECT_TRUE(json["seconds"].has("convert"));

  const Raster raster = readRaster(dir.path("out/projection.tif"));
  ASSERT_EQ(1u, raster.bands.size());
  EXPECT_EQ("projection", raster.bands[0].name);
  expectCells(HandMap::projection, raster.bands[0].cells, "projection");
}

TEST(Project, writesItsFiles)
{
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  const auto run = mapconv(
      {"project", dir.path("hand.bt"), "--z-min", "-0.5", "--z-max", "inf", "-o", dir.path("out")});
  ASSERT_EQ(0, run.status) << run.err;
  std::size_t count = 0;
  for (const char* ending : {"tif", "gridmap", "pgm", "yaml", "png"})
    count += std::filesystem::exists(dir.path(std::string("out/projection.") + ending));
  EXPECT_EQ(5u, count);
  EXPECT_TRUE(contains(run.out, "free")) << run.out;
}

TEST(Project, heightsInTheWrongOrderAreWrongUsage)
{
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  for (const char* zMax : {"1", "2", "nan", "high"})
  {
    const auto run = mapconv(
        {"project", dir.path("hand.bt"), "--z-min", "2", "--z-max", zMax, "-o", dir.path("out")});
    EXPECT_EQ(2, run.status) << zMax;
    EXPECT_TRUE(isOneError(run.err)) << run.err;
    EXPECT_TRUE(contains(run.err, "--z-max")) << run.err;
  }
  EXPECT_FALSE(std::filesystem::exists(dir.path("out")));
}
