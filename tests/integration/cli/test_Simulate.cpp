#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "Program.h"
#include "Raster.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

namespace
{
/** A room of 4 × 3 × 2.5 m with a crate, through which a robot drives 1 m. */
const std::string kRoom = R"([world]
bounds = -0.2 -0.2 -0.2  4.2 3.2 2.7
[box.floor]
min = -0.2 -0.2 -0.2
max = 4.2 3.2 0
[box.ceiling]
min = -0.2 -0.2 2.5
max = 4.2 3.2 2.7
[box.west]
min = -0.2 -0.2 0
max = 0 3.2 2.5
[box.east]
min = 4 -0.2 0
max = 4.2 3.2 2.5
[box.south]
min = -0.2 -0.2 0
max = 4.2 0 2.5
[box.north]
min = -0.2 3 0
max = 4.2 3.2 2.5
[box.crate]
min = 2.5 2.2 0
max = 3.1 2.8 0.5
[sensor.lidar]
kind = lidar
pose = 0 0 1  0 0 0
rate = 4
beams = 40
elevationMin = -60
elevationMax = 60
azimuthSteps = 180
maxRange = 10
rangeNoise = 0.005
[trajectory]
waypoints = [1 1.5 0] [2 1.5 0]
speed = 0.5
[truth]
resolution = 0.1
)";

class Simulate : public ::testing::Test
{
 protected:
  Outcome simulate(const std::string& world, const std::string& out,
                   const std::vector<std::string>& more = {}) const
  {
    std::ofstream(m_dir.path("room.ini")) << world;
    std::vector<std::string> arguments = {"simulate", m_dir.path("room.ini"), "-o",
                                          m_dir.path(out)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mapconv(arguments);
  }
  std::string bytes(const std::string& file) const { return readBytes(m_dir.path(file)); }

  /** The one-line error of a world in which `from` is replaced. */
  std::string errorOf(const std::string& from, const std::string& to) const
  {
    std::string world = kRoom;
    const auto at = world.find(from);
    EXPECT_NE(std::string::npos, at) << from;
    world.replace(at, from.size(), to);
    const Outcome outcome = simulate(world, "bad");
    EXPECT_EQ(1, outcome.status) << from;
    EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "room.ini")) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(m_dir.path("bad")));
    return outcome.err;
  }

  TempDir m_dir;
};
}  // namespace

TEST_F(Simulate, WritesLogsAndTruthThatConvertReads)
{
  const Outcome outcome = simulate(kRoom, "out", {"--json"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  const auto json = parseJson(outcome.out);
  EXPECT_NEAR(2, json["duration"].number, 1e-6);
  EXPECT_EQ(9, json["scans"].number);  // at 0, 0.25 … 2 s
  EXPECT_NEAR(1, json["way"].number, 1e-6);
  for (const char* name : {"scans.rawlog", "frames.rawlog", "scans.simplemap", "trajectory.csv",
                           "truth.tif", "truth_ground.png"})
    EXPECT_TRUE(std::filesystem::exists(m_dir.path(std::string("out/") + name))) << name;

  const Raster truth = readRaster(m_dir.path("out/truth.tif"));
  EXPECT_EQ(44, truth.width);
  EXPECT_EQ(34, truth.height);
  ASSERT_EQ(6u, truth.bands.size());
  EXPECT_EQ("floor", truth.bands[0].name);
  EXPECT_EQ("inView", truth.bands[5].name);

  // the map of each log has the room's free floor where the truth has it
  for (const char* log : {"scans.rawlog", "frames.rawlog", "scans.simplemap"})
  {
    ASSERT_EQ(0, mapconv({"convert", m_dir.path(std::string("out/") + log), "-o", m_dir.path("map"),
                          "--resolution", "0.1"})
                     .status)
        << log;
    const Raster map = readRaster(m_dir.path("map/layers.tif"));
    std::size_t free = 0;
    for (const double floor : map.bands[0].cells) free += std::abs(floor) < 0.11;
    EXPECT_GT(free, 900u) << log;  // of 1200, less the crate's shadow and gaps between beams
  }
}

TEST_F(Simulate, TheSeedDecides)
{
  ASSERT_EQ(0, simulate(kRoom, "a").status);
  ASSERT_EQ(0, simulate(kRoom, "b", {"--seed", "1"}).status);
  ASSERT_EQ(0, simulate(kRoom, "c", {"--seed", "2"}).status);
  for (const char* name : {"scans.rawlog", "frames.rawlog", "scans.simplemap", "trajectory.csv",
                           "truth.tif", "truth_ground.png"})
    EXPECT_EQ(bytes(std::string("a/") + name), bytes(std::string("b/") + name)) << name;
  EXPECT_NE(bytes("a/scans.rawlog"), bytes("c/scans.rawlog"));
  EXPECT_EQ(bytes("a/trajectory.csv"), bytes("c/trajectory.csv"));
}

TEST_F(Simulate, BadWorldsAreNamed)
{
  std::string error = errorOf("[box.crate]", "[cube.crate]");
  EXPECT_TRUE(contains(error, "cube")) << error;
  EXPECT_TRUE(contains(error, "sphere")) << error;  // the kinds that there are
  error = errorOf("max = 3.1 2.8 0.5", "max = 3.1 2.8 -0.5");
  EXPECT_TRUE(contains(error, "'box.crate'") && contains(error, "max")) << error;
  error = errorOf("[sensor.lidar]", "[lidar]");
  EXPECT_TRUE(contains(error, "lidar")) << error;
  error = errorOf("[1 1.5 0] [2 1.5 0]", "[1 1.5 0] [2.8 2.5 0]");
  EXPECT_TRUE(contains(error, "'trajectory'") && contains(error, "waypoints")) << error;
  error = errorOf("beams = 40", "beams = -40");
  EXPECT_TRUE(contains(error, "'sensor.lidar'") && contains(error, "beams = '-40'")) << error;
  error = errorOf("resolution = 0.1", "resolution = 0.0001");
  EXPECT_TRUE(contains(error, "'truth': resolution = '0.0001'")) << error;
  error = errorOf("speed = 0.5", "speed = 1e-9");
  EXPECT_TRUE(contains(error, "'trajectory': speed = '1e-9'")) << error;
  error = errorOf("[box.crate]", "[box.north]");
  EXPECT_TRUE(contains(error, "section 'box.north' is already in line")) << error;
  error = errorOf("speed = 0.5", "speed = 0.5\ncolour = red");
  EXPECT_TRUE(contains(error, "'trajectory'") && contains(error, "colour")) << error;
}

TEST_F(Simulate, ASpareSensorIsUsedIfItIsAskedFor)
{
  const std::string scanner =
      "[sensor.scanner]\nspare = true\nkind = scanner2D\npose = 0 0 0.3 0 0 0\nrate = 2\n"
      "fieldOfView = 180\nrays = 90\nmaxRange = 10\n";
  const auto scansOf = [&](const std::vector<std::string>& more)
  {
    auto arguments = more;
    arguments.push_back("--json");
    const Outcome outcome = simulate(kRoom + scanner, "out", arguments);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    return parseJson(outcome.out)["scans"].number;
  };
  EXPECT_EQ(9, scansOf({}));                       // of the lidar, at 0, 0.25 ... 2 s
  EXPECT_EQ(5, scansOf({"--sensor", "scanner"}));  // at 0, 0.5 ... 2 s
  EXPECT_EQ(14, scansOf({"--sensor", "scanner", "--sensor", "lidar"}));
  const Outcome outcome = simulate(kRoom + scanner, "bad", {"--sensor", "camera"});
  EXPECT_EQ(1, outcome.status);
  EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "no sensor 'camera'; it must be one of 'lidar' 'scanner'"))
      << outcome.err;
}

TEST_F(Simulate, WrongUsage)
{
  EXPECT_EQ(2, mapconv({"simulate"}).status);
  EXPECT_EQ(2, simulate(kRoom, "out", {"--seed", "x"}).status);
  const Outcome missing = mapconv({"simulate", m_dir.path("none.ini"), "-o", m_dir.path("out")});
  EXPECT_EQ(1, missing.status);
  EXPECT_TRUE(contains(missing.err, "none.ini")) << missing.err;
  EXPECT_FALSE(std::filesystem::exists(m_dir.path("out")));
}

TEST_F(Simulate, SeedsAreWholeNumbersOf64Bits)
{
  for (const char* seed :
       {"-1", "18446744073709551616", "", "0x10", "+5", "1.5", " 7", "7 ", "1e3"})
  {
    const Outcome outcome = simulate(kRoom, "out", {std::string("--seed=") + seed});
    EXPECT_EQ(2, outcome.status) << "'" << seed << "'";
    EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "--seed")) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(m_dir.path("out"))) << "'" << seed << "'";
  }
  EXPECT_EQ(2, simulate(kRoom, "out", {"--seed", "-1"}).status);
  EXPECT_EQ(2, simulate(kRoom, "out", {"--seed", ""}).status);
  EXPECT_EQ(2, simulate(kRoom, "out", {"--seed"}).status);
  // as a text: a double would not hold the largest seed
  for (const auto& [seed, same] : {std::pair("0", "\"seed\":0,"),
                                   {"010", "\"seed\":10,"},
                                   {"18446744073709551615", "\"seed\":18446744073709551615,"}})
  {
    const Outcome outcome = simulate(kRoom, "out", {"--seed", seed, "--json"});
    EXPECT_EQ(0, outcome.status) << outcome.err;
    std::string out = outcome.out;
    out.erase(std::remove(out.begin(), out.end(), ' '), out.end());
    EXPECT_TRUE(contains(out, same)) << outcome.out;
  }
}

TEST_F(Simulate, HelpNamesTheWorldsDocument)
{
  const Outcome outcome = mapconv({"simulate", "--help"});
  EXPECT_EQ(0, outcome.status);
  EXPECT_TRUE(contains(outcome.out, "see share/doc/worlds.md")) << outcome.out;
}
