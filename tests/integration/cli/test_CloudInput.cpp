#include <gtest/gtest.h>
#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/grid/CoordinateSystem.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include <sstream>

#include "CloudFiles.h"
#include "Program.h"
#include "Raster.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

namespace
{
const std::string kAngles = " 0 0 0";

std::vector<std::string> operator+(std::vector<std::string> words,
                                   const std::vector<std::string>& more)
{
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/** Lines of x, y, z and time, of 10 x 10 points.
 * \param spacing in x and y \param rise of z, in steps of 3 or 7, from point to point */
std::string surveyText(double spacing, double rise, double y = 48)
{
  std::ostringstream text;
  text.precision(12);
  text << "x,y,z,time\n";
  for (int i = 0; i < 100; ++i)
    text << 9.1 + spacing * (i % 10) << ',' << y + spacing * (i / 10) << ','
         << 200 + rise * (i * 7 % 10) << ',' << 0.01 * i << '\n';
  return text.str();
}

class CloudInput : public ::testing::Test
{
 protected:
  CloudInput()
  {
    FloorSurvey::writeLog(path("a.rawlog"));
    FloorSurvey::writeCloud(path("a.csv"), {});
    FloorSurvey::writeTrajectory(path("way.txt"), kAngles);
  }

  std::string path(const std::string& name) const { return m_dir.path(name); }
  void write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name)) << text;
  }
  /** A run of convert or terrain into a folder of the input's name. */
  Outcome make(const std::string& command, const std::string& file,
               const std::vector<std::string>& flags = {}) const
  {
    const std::string out = path(file) + "." + command;
    return mapconv(std::vector<std::string>{command, path(file), "-o", out, "--resolution", "0.125",
                                            "--json"} +
                   flags);
  }
  std::string bytesOf(const std::string& command, const std::string& file) const
  {
    const std::string name = command == "convert" ? "voxels.bt" : "layers.tif";
    return readBytes(path(file) + "." + command + "/" + name);
  }
  std::vector<std::string> along(const std::string& trajectory) const
  {
    return {"--trajectory", path(trajectory)};
  }
  /** Expects of convert and terrain the same map as of the log. */
  void expectSameAsLog(const std::string& cloud, const std::vector<std::string>& flags) const
  {
    const std::vector<std::string> origin = {"--origin", "448258,5411929,0"};
    for (const std::string command : {"convert", "terrain"})
    {
      const std::vector<std::string> height = {"--min-clearance", "0.5"};
      const auto all = command == "convert" ? origin + height : origin;
      const auto log = make(command, "a.rawlog", all), run = make(command, cloud, all + flags);
      ASSERT_EQ(0, log.status) << log.err;
      ASSERT_EQ(0, run.status) << run.err;
      EXPECT_TRUE(bytesOf(command, "a.rawlog") == bytesOf(command, cloud)) << command;
    }
  }
  /** One error that holds these words, of convert and of terrain, which leave nothing. */
  void expectErrors(const std::string& file, const std::vector<std::string>& flags,
                    const std::vector<std::string>& words) const
  {
    for (const std::string command : {"convert", "terrain"})
    {
      std::filesystem::remove_all(path(file) + "." + command);
      const auto run = make(command, file, flags);
      EXPECT_EQ(1, run.status) << command;
      EXPECT_EQ("", run.out);
      EXPECT_TRUE(isOneError(run.err)) << run.err;
      for (const auto& word : words)
        EXPECT_TRUE(contains(run.err, word)) << word << " in: " << run.err;
      EXPECT_FALSE(std::filesystem::exists(path(file) + "." + command));
    }
  }

  TempDir m_dir;
};
}  // namespace

TEST_F(CloudInput, givesTheMapOfTheSameRaysInALog) { expectSameAsLog("a.csv", along("way.txt")); }

TEST_F(CloudInput, trajectoriesHaveThreeFormsWithCommasOrBlanks)
{
  FloorSurvey::writeTrajectory(path("comma.csv"), kAngles, ',');
  FloorSurvey::writeTrajectory(path("tum.txt"), " 0 0 0 1");
  for (const std::string way : {"comma.csv", "tum.txt"}) expectSameAsLog("a.csv", along(way));
}

TEST_F(CloudInput, covariancesOfTheTrajectoryAreUsed)
{
  std::string closing = kAngles;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column) closing += row == column ? " 0.0001" : " 0";
  FloorSurvey::writeTrajectory(path("sure.txt"), closing);
  const auto run = make("terrain", "a.csv", along("sure.txt"));
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ(parseJson(run.out)["scansWithCovariance"].number, FloorSurvey::kPoints);
  const auto plain = make("terrain", "a.csv", along("way.txt"));
  EXPECT_EQ(parseJson(plain.out)["scansWithCovariance"].number, 0);
}

TEST_F(CloudInput, timesHaveAUnitAndAnOffset)
{
  FloorSurvey::Text text;
  text.timeUnit = 1e-3;
  text.timeOffset = 1.6e9 - 5;
  FloorSurvey::writeCloud(path("ms.csv"), text);
  expectSameAsLog(
      "ms.csv", along("way.txt") +
                    std::vector<std::string>{"--time-unit", "1e-3", "--time-offset", "1599999995"});
}

TEST_F(CloudInput, columnsWithoutNamesAreNamed)
{
  FloorSurvey::Text text;
  text.header = "";
  FloorSurvey::writeCloud(path("bare.csv"), text);
  expectErrors("bare.csv", along("way.txt"), {"have no times", "info and ground do without"});
  expectSameAsLog("bare.csv", along("way.txt") + std::vector<std::string>{"--columns", "x,y,z,t"});
  expectErrors("bare.csv", along("way.txt") + std::vector<std::string>{"--columns", "x,y,h,t"},
               {"columns = x,y,h,t", "must name x, y and z"});
}

TEST_F(CloudInput, withoutATrajectoryOneErrorSaysWhatDoesWithout)
{
  expectErrors("a.csv", {}, {"a.csv", "--trajectory FILE", "info and ground do without"});
  expectErrors("a.csv", along("none.txt"), {"none.txt"});
  write("bad.txt", "0 1 2 3 0 0 0\n1 2 3\n");
  expectErrors("a.csv", along("bad.txt"), {"bad.txt, line 2", "has 3 columns"});
}

TEST_F(CloudInput, aTrajectoryOfAnotherTimeIsAnErrorWithTheTimesOfBoth)
{
  write("late.txt", "0 448258 5411930 201 0 0 0\n12.5 448258 5411930 201 0 0 0\n");
  expectErrors("a.csv", along("late.txt"),
               {"a.csv: not one of its points has a time that ", "late.txt covers",
                "they are 1600000000 to 1600000074.75 s", "the poses 0 to 12.5 s",
                "--time-unit and --time-offset"});
}

TEST_F(CloudInput, aTrajectoryInAnotherFrameIsAnErrorWithItsDistance)
{
  const std::string question = " km from its points; are both in one coordinate system and unit?";
  write("local.txt", "1.6e9 0 0 0 0 0 0\n1600000080 9 0 0 0 0 0\n");
  expectErrors("a.csv", along("local.txt"),
               {"a.csv: the poses of " + path("local.txt") + " are 5430" + question});
  write("local.csv", "x,y,z,time\n0,0,0,1.6e9\n");
  expectErrors("local.csv", along("way.txt"),
               {"local.csv: the poses of " + path("way.txt") + " are 5430" + question});
  write("near.txt", "1.6e9 398258 5401929 200 0 0 0\n");  // too far for a lidar, but who knows
  EXPECT_FALSE(contains(make("terrain", "a.csv", along("near.txt")).err, question));
}

TEST_F(CloudInput, pointsOutsideTheTrajectoryAreCounted)
{
  write("half.txt", "1.6e9 448258 5411930 201 0 0 0\n");  // 0.1 s around it are covered
  for (const std::string command : {"convert", "terrain"})
  {
    const auto run = make(command, "a.csv", along("half.txt"));
    EXPECT_EQ(0, run.status) << run.err;
    EXPECT_TRUE(contains(run.err, "warning: 299 of 300 points left out: " + path("half.txt") +
                                      " has no pose at their times\n"))
        << run.err;
  }
}

TEST_F(CloudInput, optionsOfCloudsHaveNoEffectOnLogs)
{
  for (const std::string command : {"convert", "terrain"})
  {
    const auto run =
        make(command, "a.rawlog",
             along("way.txt") + std::vector<std::string>{"--unit", "ft", "--columns", "x,y,z",
                                                         "--time-offset", "3"});
    EXPECT_EQ(0, run.status) << run.err;
    EXPECT_TRUE(contains(
        run.err, "warning: --columns, --unit, --trajectory, --time-offset have no effect: " +
                     path("a.rawlog") + " is no cloud of points"))
        << run.err;
  }
}

// EPSG:2992 is in international feet.
TEST_F(CloudInput, aCloudInFeetLiesWhereItsSystemHasIt)
{
  FloorSurvey::Text text;
  text.unit = grid::kFoot;
  FloorSurvey::writeCloud(path("feet.csv"), text);
  FloorSurvey::writeTrajectory(path("feet.txt"), kAngles, ' ', grid::kFoot);
  for (const auto& flags : {std::vector<std::string>{"--unit", "ft"}, {"--crs", "EPSG:2992"}})
  {
    const auto run = make("terrain", "feet.csv", along("feet.txt") + flags);
    ASSERT_EQ(0, run.status) << run.err;
    const auto json = parseJson(run.out);
    EXPECT_EQ(json["inputKind"].text, "cloud (300 points in feet)");
    EXPECT_EQ(json["metresPerUnit"].number, 0.3048);
    EXPECT_NEAR(json["xMin"].number, FloorSurvey::kX, 0.2) << "metres";
    EXPECT_EQ(json["originX"].number, FloorSurvey::kX);
    const std::string tiff = path("feet.csv.terrain/layers.tif");
    const auto raster = readRaster(tiff);
    EXPECT_NEAR(raster.transform[0] * 0.3048, json["xMin"].number, 1e-6);
    EXPECT_NEAR(raster.transform[1] * 0.3048, 0.125, 1e-9);
    EXPECT_NEAR(raster.transform[3] * 0.3048, json["yMax"].number, 1e-6);
    EXPECT_EQ(grid::readGeoReference(tiff).unit, 0.3048);
    EXPECT_EQ(grid::readGeoReference(tiff).coordinateSystem, flags[0] == "--crs" ? flags[1] : "");
    EXPECT_TRUE(contains(readBytes(path("feet.csv.terrain/traversability.yaml")),
                         "resolution: 0.125\norigin: [44825"));
  }
}

TEST_F(CloudInput, originsOfCloudsAreInTheirUnit)
{
  FloorSurvey::Text text;
  text.unit = grid::kFoot;
  FloorSurvey::writeCloud(path("feet.csv"), text);
  FloorSurvey::writeTrajectory(path("feet.txt"), kAngles, ' ', grid::kFoot);
  const auto run = make("terrain", "feet.csv",
                        along("feet.txt") + std::vector<std::string>{"--unit", "ft", "--origin",
                                                                     "1470000,17755000,600"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_NEAR(parseJson(run.out)["originX"].number, 1470000 * 0.3048, 1e-9);
  EXPECT_NEAR(parseJson(run.out)["originZ"].number, 600 * 0.3048, 1e-9);
}

TEST_F(CloudInput, theUnitThatALasNamesIsTakenAndShown)
{
  cloud::PointCloud cloud;
  cloud.x = {1.5, 2.5};
  cloud.y = {0, 1};
  cloud.z = {0, 3};
  cloud.time = {0, 1};
  cloud.unit = cloud.heightUnit = grid::kSurveyFoot;
  cloud.coordinateSystem = "EPSG:2227";
  cloud::writeCloudFile(path("a.las"), cloud);
  const auto info = mapconv({"info", path("a.las")});
  EXPECT_TRUE(contains(info.out, "x            4.921 to 8.202 (3.281 US survey feet)\n"))
      << info.out;
  EXPECT_TRUE(contains(info.out, "units        US survey feet\n")) << info.out;
  const auto json = parseJson(mapconv({"info", path("a.las"), "--json"}).out);
  EXPECT_NEAR(json["metresPerUnit"].number, grid::kSurveyFoot, 1e-12);
  write("way.txt", "0 0 0 3 0 0 0\n1 0 0 3 0 0 0\n");
  const auto run = make("terrain", "a.las", along("way.txt"));
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ(parseJson(run.out)["crs"].text, "EPSG:2227");
  EXPECT_NEAR(parseJson(run.out)["metresPerUnit"].number, grid::kSurveyFoot, 1e-12);
}

TEST_F(CloudInput, degreesAreRefusedWithARemedy)
{
  cloud::PointCloud cloud;
  cloud.x = {9.1, 9.2};
  cloud.y = {48, 48.1};
  cloud.z = {200, 230};
  cloud.time = {0, 1};
  cloud.coordinateSystem =
      "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,"
      "298.257223563]],PRIMEM[\"Greenwich\",0],"
      "UNIT[\"degree\",0.0174532925199433]]";
  cloud::writeCloudFile(path("a.las"), cloud);
  expectErrors(
      "a.las", along("way.txt"),
      {"a.las: its coordinates are degrees", "pdal translate IN.las OUT.las reprojection"});
  const auto info = mapconv({"info", path("a.las")});
  EXPECT_TRUE(contains(info.out, "(0.100 degrees)\n")) << info.out;
  EXPECT_TRUE(contains(info.out, "units        degrees, heights in m\n")) << info.out;
}

TEST_F(CloudInput, whatSeemsToBeDegreesGetsAWarning)
{
  write("way.txt", "0 9 48 210 0 0 0\n1 9 48 210 0 0 0\n");
  write("seems.csv", surveyText(1e-5, 0.3));  // a metre from point to point
  const auto run = make("convert", "seems.csv", along("way.txt"));
  EXPECT_TRUE(contains(run.err, "warning: " + path("seems.csv") +
                                    ": its coordinates seem to be degrees, but are taken for "
                                    "metres; reproject it"))
      << run.err;
  for (const auto& cloud : {surveyText(1e-5, 0.03),      // less than a metre high
                            surveyText(0.03, 0.3),       // wide
                            surveyText(1e-5, 0.3, 148),  // y is no latitude
                            surveyText(0.01, 0.5),       // a mast of 0.1 m
                            surveyText(0.002, 0.3)})     // a wire
  {
    write("seems.csv", cloud);
    EXPECT_FALSE(contains(make("convert", "seems.csv", along("way.txt")).err, "degrees")) << cloud;
  }
}

TEST_F(CloudInput, aSystemThatIsNotKnownGetsAWarningAndIsLeftOut)
{
  cloud::PointCloud cloud;
  cloud.x = {0, 1};
  cloud.y = cloud.z = cloud.time = {0, 1};
  cloud.coordinateSystem = "PROJCS[\"somewhere\",GEOGCS[]]";
  cloud::writeCloudFile(path("a.las"), cloud);
  write("way.txt", "0 0 0 3 0 0 0\n1 0 0 3 0 0 0\n");
  const auto run = make("terrain", "a.las", along("way.txt"));
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_TRUE(contains(run.err,
                       "a.las: its coordinate system is not known, so GeoTIFFs name none; "
                       "--crs does"))
      << run.err;
  EXPECT_EQ(grid::readGeoReference(path("a.las.terrain/layers.tif")).coordinateSystem, "");
}

TEST_F(CloudInput, systemsInDegreesAreWrongUsage)
{
  const auto run = make("terrain", "a.rawlog", {"--crs", "EPSG:4326"});
  EXPECT_EQ(2, run.status);
  EXPECT_TRUE(contains(run.err, "give a projected system")) << run.err;
}
