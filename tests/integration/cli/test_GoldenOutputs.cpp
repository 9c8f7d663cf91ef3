#include <gtest/gtest.h>

#include <filesystem>

#include "Golden.h"
#include "OutputManifest.h"
#include "Program.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

// What is in the files that the program writes; see manifestOf().

namespace
{
const std::string kVelodyne = MRPT_MAPCONV_SHARED_DIR "/vlp16_3scans.rawlog";

/** Runs the program, whose output goes to DIR/out, and compares what is there. */
void expectOutputs(const std::string& name, const TempDir& dir,
                   const std::vector<std::string>& arguments)
{
  auto words = arguments;
  words.insert(words.end(), {"-o", dir.path("out")});
  const auto run = mapconv(words);
  ASSERT_EQ(0, run.status) << name << ": " << run.err;
  expectGolden(name + "_outputs.txt",
               withPlaceholders(manifestOf(dir.path("out")), {{dir.path(), "DIR"}}));
}

std::string buildingIn(const TempDir& dir)
{
  const auto run =
      mapconv({"sample-map", "building", "-o", dir.path("building.bt"), "--resolution", "0.2"});
  EXPECT_EQ(0, run.status) << run.err;
  return dir.path("building.bt");
}
}  // namespace

TEST(GoldenOutputs, convert)
{
  const TempDir dir;
  expectOutputs("convert", dir,
                {"convert", buildingIn(dir), "--min-clearance", "0.6", "--max-slope", "0.5",
                 "--max-step", "0.2"});
}

TEST(GoldenOutputs, project)
{
  const TempDir dir;
  expectOutputs("project", dir, {"project", buildingIn(dir), "--z-min", "0.1", "--z-max", "1.8"});
}

TEST(GoldenOutputs, insert)
{
  if (!std::filesystem::exists(kVelodyne)) GTEST_SKIP() << kVelodyne << " is not there";
  const TempDir dir;
  expectOutputs("insert", dir, {"insert", kVelodyne, "--static", "--structure", "1", "2"});
}

TEST(GoldenOutputs, insertWithoutTheFilter)
{
  const std::string file = "/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const TempDir dir;
  expectOutputs("insert_no_filter", dir,
                {"insert", file, "--no-reflection-filter", "--resolution", "0.1"});
}

TEST(GoldenOutputs, terrain)
{
  if (!std::filesystem::exists(kVelodyne)) GTEST_SKIP() << kVelodyne << " is not there";
  const TempDir dir;
  expectOutputs("terrain", dir, {"terrain", kVelodyne, "--static", "--max-height", "3"});
}

TEST(GoldenOutputs, ground)
{
  const std::string file = MRPT_MAPCONV_SHARED_DIR "/real/isprs_samp31.pcd";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const TempDir dir;
  std::filesystem::create_directory(dir.path("out"));
  expectOutputs("ground", dir,
                {"ground", file, "--cell-size", "1", "--points", dir.path("out/points.ply")});
}

TEST(GoldenOutputs, plan)
{
  const TempDir dir;
  const auto converted = mapconv({"convert", buildingIn(dir), "-o", dir.path("maps"),
                                  "--min-clearance", "0.6", "--max-step", "0.2"});
  ASSERT_EQ(0, converted.status) << converted.err;
  std::filesystem::create_directory(dir.path("out"));
  const auto planned =
      mapconv({"plan", dir.path("maps"), "--robot", "ground", "--from", "-3,1.5", "--to", "7,4",
               "--robot-radius", "0.25", "-o", dir.path("out/path.csv")});
  ASSERT_EQ(0, planned.status) << planned.err;
  expectGolden("plan_outputs.txt", manifestOf(dir.path("out")));
}
