#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "Program.h"
#include "Raster.h"
#include "ScanFiles.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

namespace
{
constexpr double kUnknown = NAN;

/** p after one free and one occupied reading: 10 and 35 sixteenths of log-odds. */
const double kFreeOnce = 1 / (1 + std::exp(10 / 16.0));
const double kHitOnce = 1 / (1 + std::exp(-35 / 16.0));

/** With cells of 0.5 m and lines along the axes only, all that is known lies on the line y = 0. */
const std::string kIni =
    "[map]\nresolution = 0.5\n[scanInsertion]\nsectors = 4\nstructureMinZ = 2.2\nstructureMaxZ = "
    "2.6\n"
    "pHit = 0.9\npMiss = 0.35\npMin = 0.03\npMax = 0.97\n";

/** A chair in cell 3, a wall in cell 6 that reaches up to the ceiling, a ghost behind it in cell
 * 10, all seen from cell 0. */
mrpt::obs::CObservation::Ptr chairWallAndGhost(double seconds)
{
  return cloudOn({{1.75f, 0.25f, 0.5f},
                  {3.25f, 0.25f, 0.75f},
                  {3.25f, 0.25f, 2.4f},
                  {5.25f, 0.25f, 0.75f},
                  {1.25f, 0.25f, 0.01f}},  // the floor
                 {0.25, 0.25, 1}, seconds);
}

/** Inserts a file of scans with an ini file. */
class Insert : public ::testing::Test
{
 protected:
  Insert()
  {
    std::ofstream(m_dir.path("row.ini")) << kIni;
    writeObjects(m_dir.path("row.rawlog"), {chairWallAndGhost(0)});
  }

  Outcome insert(const std::string& file, std::vector<std::string> flags = {})
  {
    flags.insert(flags.begin(), {"insert", m_dir.path(file), "-o", m_dir.path("out"), "-c",
                                 m_dir.path("row.ini"), "--json"});
    return mapconv(flags);
  }
  JsonValue inserted(const std::string& file, const std::vector<std::string>& flags = {})
  {
    const auto run = insert(file, flags);
    EXPECT_EQ(0, run.status) << run.err;
    const bool filtered = flags.empty() || flags.back() != "--no-reflection-filter";
    if (filtered)
      EXPECT_EQ("", run.err);
    else  // row.ini says where walls are
      EXPECT_TRUE(contains(run.err, "structureMaxZ of")) << run.err;
    return parseJson(run.out);
  }
  std::string output(const std::string& name) const { return m_dir.path("out/" + name); }

  /** Expects these probabilities in the row from cell x0 on. */
  void expectRow(int x0, const std::vector<double>& cells, const std::string& what) const
  {
    const Raster raster = readRaster(output("map.tif"));
    EXPECT_EQ(1, raster.height) << what;
    EXPECT_DOUBLE_EQ(0.5 * x0, raster.transform[0]) << what;
    ASSERT_EQ(1U, raster.bands.size());
    expectCells(cells, raster.bands[0].cells, what);
  }

  TempDir m_dir;
};

/** The grid of a .gridmap, which has to be of MRPT's own class. */
mrpt::maps::COccupancyGridMap2D::Ptr readGrid(const std::string& path)
{
  mrpt::io::CFileGZInputStream stream(path);
  const auto object = mrpt::serialization::archiveFrom(stream).ReadObject();
  EXPECT_STREQ("mrpt::maps::COccupancyGridMap2D", object->GetRuntimeClass()->className);
  return std::dynamic_pointer_cast<mrpt::maps::COccupancyGridMap2D>(object);
}

/** Reads map.tif, .pgm and .gridmap back and compares them, and what a summary says of them. */
void expectFilesAgree(const std::string& dir, const JsonValue& json)
{
  const Raster tif = readRaster(dir + "/map.tif"), pgm = readRaster(dir + "/map.pgm");
  const auto grid = readGrid(dir + "/map.gridmap");
  ASSERT_EQ(1U, tif.bands.size());
  EXPECT_EQ("occupancy", tif.bands[0].name);
  EXPECT_EQ("Float32", tif.bands[0].type);
  EXPECT_TRUE(tif.bands[0].noDataIsNan);
  ASSERT_EQ(tif.width, pgm.width);
  ASSERT_EQ(tif.height, pgm.height);
  ASSERT_EQ(tif.width, static_cast<int>(grid->getSizeX()));
  ASSERT_EQ(tif.height, static_cast<int>(grid->getSizeY()));
  EXPECT_NEAR(tif.transform[0], static_cast<double>(grid->getXMin()), 1e-5);
  EXPECT_NEAR(tif.transform[3], static_cast<double>(grid->getYMax()), 1e-5);
  EXPECT_FLOAT_EQ(static_cast<float>(tif.transform[1]), grid->getResolution());

  double free = 0, occupied = 0, unknown = 0;
  std::size_t wrong = 0;
  for (int y = 0; y < tif.height; ++y)
    for (int x = 0; x < tif.width; ++x)
    {
      const auto i = static_cast<std::size_t>(y * tif.width + x);
      const double p = tif.bands[0].cells[i], pixel = pgm.bands[0].cells[i];
      const int raw = grid->getRow(y)[x];  // log-odds of free in sixteenths
      ++(std::isnan(p) ? unknown : p < 0.5 ? free : occupied);
      const double expectedPixel = std::isnan(p) ? 205 : p < 0.5 ? 254 : 0;
      const double expected = 1 / (1 + std::exp(raw / 16.0));
      const bool same = raw == 0 ? std::isnan(p) : std::abs(p - expected) < 1e-5;
      if (!same || pixel != expectedPixel) ++wrong;
    }
  EXPECT_EQ(0U, wrong) << "cells differ in " << dir;
  EXPECT_EQ(free, json["free"].number);
  EXPECT_EQ(occupied, json["occupied"].number);
  EXPECT_EQ(unknown, json["unknown"].number);
  EXPECT_EQ(tif.width, json["width"].number);
  EXPECT_EQ(tif.height, json["height"].number);
  EXPECT_GT(free, 0);
  EXPECT_GT(occupied, 0);
}
}  // namespace

TEST_F(Insert, keepsWholeShapesAndCutsAtTheWall)
{
  const double f = kFreeOnce, o = kHitOnce;
  inserted("row.rawlog");
  expectRow(0, {f, f, f, o, f, f, o}, "whole shape, cut");
  inserted("row.rawlog", {"--no-reflection-filter"});
  expectRow(0, {f, f, f, o, f, f, o, f, f, f, o}, "whole shape, not cut");
  inserted("row.rawlog", {"--model", "closestPoint"});
  expectRow(0, {f, f, f, o}, "closest point");
}

TEST_F(Insert, writesAllFilesAndNoOther)
{
  inserted("row.rawlog");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(m_dir.path("out")))
    names.insert(entry.path().filename().string());
  EXPECT_EQ((std::set<std::string>{"map.gridmap", "map.pgm", "map.yaml", "map.png", "map.tif"}),
            names);
  const std::string yaml = readBytes(output("map.yaml")), png = readBytes(output("map.png"));
  for (const char* line : {"image: map.pgm", "resolution: 0.5", "origin: [0, 0, 0]"})
    EXPECT_TRUE(contains(yaml, line)) << line << " in\n" << yaml;
  EXPECT_EQ("\x89PNG", png.substr(0, 4));
  EXPECT_TRUE(contains(png.substr(png.size() - 12), "IEND"));
}

TEST_F(Insert, filesAgreeCellByCell)
{
  writeObjects(m_dir.path("drive.rawlog"),
               {robotAt(-0.5, 0), chairWallAndGhost(0), chairWallAndGhost(1), robotAt(0.5, 2)});
  expectFilesAgree(m_dir.path("out"), inserted("drive.rawlog"));
}

TEST_F(Insert, scansAreAtTheirPoses)
{
  writeObjects(m_dir.path("drive.rawlog"),
               {robotAt(-20, 0), chairWallAndGhost(0), chairWallAndGhost(1), robotAt(-16, 2)});
  inserted("drive.rawlog");
  const double f = kFreeOnce, o = kHitOnce, ff = 1 / (1 + std::exp(20 / 16.0));
  const double fo = 1 / (1 + std::exp((10 - 35) / 16.0));
  // the second scan is 2 m, 4 cells, farther on
  expectRow(-40, {f, f, f, o, ff, ff, fo, o, f, f, o}, "two poses");
}

TEST_F(Insert, severalReadingsAreKeptWithinTheClamps)
{
  writeObjects(m_dir.path("still.rawlog"),
               {chairWallAndGhost(0), chairWallAndGhost(1), chairWallAndGhost(2)});
  const JsonValue json = inserted("still.rawlog", {"--static"});
  EXPECT_EQ(3, json["scans3D"].number);
  const double f = 1 / (1 + std::exp(30 / 16.0)), o = 1 / (1 + std::exp(-55 / 16.0));
  expectRow(0, {f, f, f, o, f, f, o}, "three times the same");
}

TEST_F(Insert, summaryCountsCellsScansAndPoints)
{
  const JsonValue json = inserted("row.rawlog");
  EXPECT_EQ(5, json["free"].number);
  EXPECT_EQ(2, json["occupied"].number);
  EXPECT_EQ(0, json["unknown"].number);
  EXPECT_EQ(0.5, json["resolution"].number);
  EXPECT_EQ(1, json["scans3D"].number);
  EXPECT_EQ(0, json["scans2D"].number);
  EXPECT_EQ(0, json["skipped"].number);
  EXPECT_EQ(5, json["points"].number);
  EXPECT_EQ(0.25, json["shareWithWall"].number) << "one of four azimuths";
  EXPECT_GT(json["scansPerSecond"].number, 0);
  EXPECT_NEAR(5 * json["scansPerSecond"].number, json["pointsPerSecond"].number,
              1e-6 * json["pointsPerSecond"].number);
  for (const char* stage : {"load", "insert", "write"})
    EXPECT_GT(json["seconds"][stage].number, 0) << stage;
  EXPECT_LT(1 / json["scansPerSecond"].number, json["seconds"]["insert"].number)
      << "reading is no part of the speed";
  const JsonValue uncut = inserted("row.rawlog", {"--no-reflection-filter"});
  EXPECT_EQ(JsonValue::Kind::Null, uncut["shareWithWall"].kind);
}

TEST_F(Insert, summaryIsForPeople)
{
  const auto run = mapconv(
      {"insert", m_dir.path("row.rawlog"), "-o", m_dir.path("out"), "-c", m_dir.path("row.ini")});
  ASSERT_EQ(0, run.status) << run.err;
  for (const char* part :
       {"rawlog (1 scan)", "7 (7 x 1) of 0.5 m", "5 free", "2 occupied", "0 unknown", "wholeShape",
        "1 3D scans with 5 points, 0 2D scans", "25.0 % of the azimuths", "3D scans/s",
        "points/s of insertion, decoding included", "sectors = 4"})
    EXPECT_TRUE(contains(run.out, part)) << part << " in\n" << run.out;
  EXPECT_FALSE(contains(run.out, "skipped")) << run.out;
}

TEST_F(Insert, simplemapsAndLogsOfAnyNameAreRead)
{
  const double f = kFreeOnce, o = kHitOnce;
  writeSimpleMap(m_dir.path("row.simplemap"), {chairWallAndGhost(0)});
  std::filesystem::copy(m_dir.path("row.simplemap"), m_dir.path("simple.map"));
  std::filesystem::copy(m_dir.path("row.rawlog"), m_dir.path("drive.log"));
  for (const char* name : {"row.simplemap", "simple.map", "drive.log"})
  {
    inserted(name);
    expectRow(0, {f, f, f, o, f, f, o}, name);
  }
}

TEST_F(Insert, scansIn2DAreCountedAndWarnedOf)
{
  writeSimpleMap(m_dir.path("both.simplemap"), {chairWallAndGhost(0), scan2D(0)});
  const auto run = insert("both.simplemap");
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "--no-2d") && contains(run.err, "insert2D = false")) << run.err;
  EXPECT_EQ(1, parseJson(run.out)["scans2D"].number);
  EXPECT_GT(readRaster(output("map.tif")).height, 1) << "its ray to the side";
}

TEST_F(Insert, scansIn2DAreLeftOutByFlagAndByIni)
{
  writeSimpleMap(m_dir.path("both.simplemap"), {chairWallAndGhost(0), scan2D(0)});
  const auto expectLeftOut = [this](const JsonValue& json)
  {
    EXPECT_FALSE(json["parameters"]["insert2D"].truth);
    EXPECT_EQ(0, json["scans2D"].number);
    EXPECT_EQ(1, json["skipped"].number);
    const auto& reasons = json["skippedBecause"].object;
    ASSERT_EQ(1U, reasons.size());
    EXPECT_TRUE(contains(reasons.begin()->first, "2D")) << reasons.begin()->first;
    EXPECT_EQ(1, readRaster(output("map.tif")).height);
  };
  expectLeftOut(inserted("both.simplemap", {"--no-2d"}));
  std::ofstream(m_dir.path("row.ini"), std::ios::app) << "insert2D = true\n";
  expectLeftOut(inserted("both.simplemap", {"--no-2d"}));
  std::ofstream(m_dir.path("row.ini")) << kIni << "insert2D = false\n";
  expectLeftOut(inserted("both.simplemap"));
}

TEST_F(Insert, optionsFor2DScansAreReadAsWell)
{
  writeSimpleMap(m_dir.path("both.simplemap"), {chairWallAndGhost(0), scan2D(0)});
  const JsonValue whole = parseJson(insert("both.simplemap").out);
  std::ofstream(m_dir.path("row.ini"), std::ios::app) << "maxDistanceInsertion = 0.6\n";
  const auto run = insert("both.simplemap");
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ(1, warningsIn(run.err)) << "no unknown key: " << run.err;
  EXPECT_EQ(1, parseJson(run.out)["scans2D"].number);
  EXPECT_LT(parseJson(run.out)["height"].number, whole["height"].number);
}

TEST_F(Insert, skippedScansAreCountedWithTheirReason)
{
  const auto empty = cloudOn({}, {0.25, 0.25, 1}, 1);
  const auto floorOnly = cloudOn({{1.25f, 0.25f, 0.01f}}, {0.25, 0.25, 1}, 2);
  const auto low = cloudOn({{1.25f, 0.25f, 0.5f}}, {0.25, 0.25, -1}, 3);
  const auto lower = cloudOn({{1.25f, 0.25f, 0.5f}}, {0.25, 0.25, -2}, 5);
  const auto nowhere = cloudOn({{1.25f, 0.25f, 0.5f}}, {0.25, 0.25, 1}, 4);
  nowhere->setSensorPose(mrpt::poses::CPose3D(NAN, 0, 1, 0, 0, 0));
  writeObjects(m_dir.path("odd.rawlog"),
               {chairWallAndGhost(0), empty, floorOnly, low, nowhere, floorOnly, lower});
  const auto run = insert("odd.rawlog", {"--static"});
  ASSERT_EQ(0, run.status) << run.err;
  const JsonValue json = parseJson(run.out);
  EXPECT_EQ(1, json["scans3D"].number);
  EXPECT_EQ(5, json["points"].number) << "of the scans that were inserted";
  EXPECT_EQ(6, json["skipped"].number);
  double reasons = 0;
  std::string all;
  for (const auto& [why, count] : json["skippedBecause"].object)
  {
    reasons += count.number;
    all += std::to_string(static_cast<int>(count.number)) + ": " + why + "; ";
    EXPECT_TRUE(contains(run.err, why)) << why << " is what the map has warned of: " << run.err;
  }
  EXPECT_EQ(6, reasons);
  EXPECT_TRUE(contains(run.err, "6 of 7 scans are skipped: ")) << "summed up: " << run.err;
  for (const char* part : {"1: it has no usable point", "2: it has no object",
                           "1: its pose is not finite", "2: the sensor is -1 m above"})  // and -2 m
    EXPECT_TRUE(contains(all, part)) << part << " in " << all;
  const double f = kFreeOnce, o = kHitOnce;
  expectRow(0, {f, f, f, o, f, f, o}, "as without them");

  const auto text = mapconv({"insert", m_dir.path("odd.rawlog"), "-o", m_dir.path("out"), "-c",
                             m_dir.path("row.ini"), "--static"});
  EXPECT_TRUE(contains(text.out, "\nskipped      6 scans, see the warning\n")) << text.out;
}

TEST_F(Insert, theResultIsTheSameWhateverTheGridHasGrownTo)
{
  // a scan far off makes the grid grow by more than it needs; what is known is all that is written
  writeObjects(m_dir.path("far.rawlog"),
               {robotAt(0, 0), chairWallAndGhost(0), chairWallAndGhost(5), robotAt(100, 5)});
  const JsonValue json = inserted("far.rawlog");
  EXPECT_EQ(207, json["width"].number);
  EXPECT_EQ(1, json["height"].number);
  EXPECT_EQ(10, json["free"].number);
  EXPECT_EQ(193, json["unknown"].number);
}

TEST_F(Insert, replacesItsFilesAndLeavesOthersAlone)
{
  std::filesystem::create_directory(m_dir.path("out"));
  std::ofstream(output("notes.txt")) << "mine";
  std::ofstream(output("map.pgm")) << "old";
  inserted("row.rawlog");
  EXPECT_EQ("mine", readBytes(output("notes.txt")));
  EXPECT_EQ("P5", readBytes(output("map.pgm")).substr(0, 2));
}

TEST(InsertRealData, standingVelodyne)
{
  const std::string file = MRPT_MAPCONV_SHARED_DIR "/vlp16_3scans.rawlog";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const TempDir dir;
  // it stands 1.8 m high in the open; what is seen above it are a few facades
  const std::vector<std::string> arguments = {"insert", file,          "-o",  dir.path("out"),
                                              "--json", "--structure", "1.9", "4"};
  EXPECT_EQ(1, mapconv(arguments).status) << "it has no poses";
  auto standing = arguments;
  standing.emplace_back("--static");
  const auto run = mapconv(standing);
  ASSERT_EQ(0, run.status) << run.err;
  const JsonValue json = parseJson(run.out);
  EXPECT_EQ(3, json["scans3D"].number);
  EXPECT_GT(json["points"].number, 15000);
  expectFilesAgree(dir.path("out"), json);
}

TEST(InsertRealData, mrptsOwnLogs)
{
  // of mrpt-common, which setup.sh installs; the heights are those of sensors without a robot
  const std::string folder = "/usr/share/mrpt/datasets/";
  for (const std::string name : {"test_velodyne_VLP16", "tests_rgbd"})
  {
    ASSERT_TRUE(std::filesystem::exists(folder + name + ".rawlog")) << name;
    const TempDir dir;
    std::ofstream(dir.path("low.ini"))
        << "[scanInsertion]\nobjectMinZ = -0.5\nreflectionFilter = 0\n";
    const auto run = mapconv({"insert", folder + name + ".rawlog", "-o", dir.path("out"), "--json",
                              "-c", dir.path("low.ini")});
    ASSERT_EQ(0, run.status) << run.err;
    expectFilesAgree(dir.path("out"), parseJson(run.out));
  }
}

TEST(InsertRealData, logsWithout3DScansAreRefused)
{
  const TempDir dir;
  for (const char* name : {"kf-slam_demo.rawlog", "localization_demo.simplemap.gz"})
  {
    const auto run = mapconv({"insert", std::string("/usr/share/mrpt/datasets/") + name, "-o",
                              dir.path("out"), "--no-reflection-filter"});
    EXPECT_EQ(1, run.status) << name;
    EXPECT_TRUE(isOneError(run.err)) << run.err;
    EXPECT_TRUE(contains(run.err, name) && contains(run.err, "3D")) << run.err;
  }
  EXPECT_EQ(0U, dir.entries());
}
