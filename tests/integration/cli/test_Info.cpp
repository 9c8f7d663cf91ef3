#include <gtest/gtest.h>
#include <mrpt/maps/COctoMap.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>

#include "OctreeFiles.h"
#include "Program.h"
#include "ScanFiles.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

namespace
{
JsonValue infoOf(const std::string& file)
{
  const auto run = mapconv({"info", file, "--json"});
  EXPECT_EQ(0, run.status) << run.err;
  EXPECT_EQ("", run.err);
  return parseJson(run.out);
}
}  // namespace

TEST(Info, countsAnOctreesLeaves)
{
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  const JsonValue json = infoOf(dir.path("hand.bt"));
  EXPECT_EQ("OcTree", json["treeType"].text);
  EXPECT_EQ(0.5, json["resolution"].number);
  // counted in the drawing of HandMap: 40 free voxels, of which 8 (x −2 and −1, y 2 and 3, z 2 and
  // 3) are stored as one leaf
  EXPECT_EQ(33, json["freeLeaves"].number);
  EXPECT_EQ(23, json["occupiedLeaves"].number);
  EXPECT_EQ(-1, json["xMin"].number);
  EXPECT_EQ(1.5, json["xMax"].number);
  EXPECT_EQ(0.5, json["yMin"].number);
  EXPECT_EQ(2, json["yMax"].number);
  EXPECT_EQ(0, json["zMin"].number);
  EXPECT_EQ(3, json["zMax"].number);
  const auto text = mapconv({"info", dir.path("hand.bt")});
  EXPECT_TRUE(contains(text.out, "56 (33 free, 23 occupied)")) << text.out;
}

TEST(Info, countsARawlogsObservations)
{
  const TempDir dir;
  writeObjects(dir.path("a.rawlog"), {robotAt(0, 0), lookDown(0.5), lookDown(1), robotAt(1, 2.5)});
  const JsonValue json = infoOf(dir.path("a.rawlog"));
  EXPECT_EQ("rawlog", json["kind"].text);
  EXPECT_EQ(2, json["observations"]["mrpt::obs::CObservationPointCloud"].number);
  EXPECT_EQ(2, json["observations"]["mrpt::obs::CObservationRobotPose"].number);
  EXPECT_EQ(2, json["scans3D"].number);
  EXPECT_NEAR(2.5, json["durationSeconds"].number, 1e-3);
  EXPECT_EQ("CObservationRobotPose", json["poses"].text);
  ASSERT_EQ(2u, json["labels"].list.size());
  EXPECT_EQ("lidar", json["labels"].list[1].text);
}

TEST(Info, saysThatPosesAreMissing)
{
  const TempDir dir;
  writeObjects(dir.path("a.rawlog"), {lookDown(0), lookDown(1)});
  EXPECT_EQ("none", infoOf(dir.path("a.rawlog"))["poses"].text);
}

TEST(Info, describesASimplemap)
{
  const TempDir dir;
  writeSimpleMap(dir.path("a.simplemap"), {0, 1, 2}, true);
  const JsonValue json = infoOf(dir.path("a.simplemap"));
  EXPECT_EQ("simplemap", json["kind"].text);
  EXPECT_EQ(3, json["keyframes"].number);
  EXPECT_EQ(3, json["scans3D"].number);
  EXPECT_EQ("keyframes", json["poses"].text);
}

TEST(Info, describesGridMapsAndOctoMaps)
{
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  ASSERT_EQ(0, mapconv({"convert", dir.path("hand.bt"), "-o", dir.path("out")}).status);
  const JsonValue grid = infoOf(dir.path("out/aerial.gridmap"));
  EXPECT_EQ("mrpt::maps::COccupancyGridMap2D", grid["kind"].text);
  EXPECT_EQ(5, grid["width"].number);
  EXPECT_EQ(3, grid["height"].number);
  EXPECT_EQ(0.5, grid["resolution"].number);
  EXPECT_EQ(HandMap::free, grid["free"].number);
  EXPECT_EQ(HandMap::occupied, grid["occupied"].number);

  auto map = mrpt::maps::COctoMap::Create(0.25);
  map->updateVoxel(0.1, 0.1, 0.1, true);
  writeObjects(dir.path("octo.map"), {map});
  const JsonValue octo = infoOf(dir.path("octo.map"));
  EXPECT_EQ("mrpt::maps::COctoMap", octo["kind"].text);
  EXPECT_EQ(0.25, octo["resolution"].number);
  EXPECT_EQ(1, octo["occupiedLeaves"].number);
}

TEST(Info, describesScanShapeMaps)
{
  const TempDir dir;
  mrpt_mapconv::CScanShapeGridMap2D map(0.1);
  map.scanInsertionOptions.profile.model = mrpt_mapconv::scan::Model::ClosestPoint;
  map.scanInsertionOptions.profile.structureMinZ = 2.25;
  map.setCell(3, 4, 0.1f);
  map.setCell(4, 4, 0.9f);
  writeObjects(dir.path("a.map"), {std::make_shared<mrpt_mapconv::CScanShapeGridMap2D>(map)});
  const JsonValue json = infoOf(dir.path("a.map"));
  EXPECT_EQ("mrpt_mapconv::CScanShapeGridMap2D", json["kind"].text);
  EXPECT_EQ(map.getSizeX(), json["width"].number);
  EXPECT_EQ(1, json["free"].number);
  EXPECT_EQ(1, json["occupied"].number);
  EXPECT_EQ("closestPoint", json["parameters"]["model"].text);
  EXPECT_EQ(2.25, json["parameters"]["structureMinZ"].number);
  EXPECT_EQ(JsonValue::Kind::Null, json["parameters"]["structureMaxZ"].kind);
  const auto text = mapconv({"info", dir.path("a.map")});
  EXPECT_TRUE(contains(text.out, "closestPoint, objects from 0.05 to 1.5 m")) << text.out;
}

TEST(Info, anyFileNameGivesValidJson)
{
  const TempDir dir;
  const std::string name = dir.path("q\"uote\\ tab\t \xFF.bt");
  HandMap::write(name);
  EXPECT_TRUE(contains(infoOf(name)["file"].text, "q\"uote\\ tab\t \xEF\xBF\xBD.bt"));
}

TEST(Info, describesCloudsOfPoints)
{
  const TempDir dir;
  std::ofstream(dir.path("a.csv"))
      << "x,y,z,classification,red\n1,2,3,2,9\n4,5,6.5,1,9\nnan,1,1,1,9\n";
  const JsonValue json = infoOf(dir.path("a.csv"));
  EXPECT_EQ("cloud", json["kind"].text);
  EXPECT_EQ(2, json["points"].number);
  EXPECT_EQ(6.5, json["zMax"].number);
  EXPECT_EQ(1, json["classes"]["2"].number);
  EXPECT_EQ(1, json["notFinite"].number);
  EXPECT_EQ("red", json["otherFields"].list.at(0).text);
  const auto text = mapconv({"info", dir.path("a.csv")}).out;
  EXPECT_TRUE(contains(text, "text, separated by commas")) << text;
  EXPECT_TRUE(contains(text, "x            1.000 to 4.000 (3.000 m)")) << text;
  EXPECT_TRUE(contains(text, "1 unclassified: 1, 2 ground: 1")) << text;
  EXPECT_TRUE(contains(text, "not read     red")) << text;
  EXPECT_TRUE(contains(text, "left out     1 point")) << text;
  EXPECT_TRUE(contains(text, "system       the file names none")) << text;
}

TEST(Info, columnsOfATextMayBeGiven)
{
  const TempDir dir;
  std::ofstream(dir.path("a.txt")) << "5 1 2 3\n";
  const auto run = mapconv({"info", dir.path("a.txt"), "--columns", "time,x,y,z", "--json"});
  EXPECT_EQ(3, parseJson(run.out)["zMax"].number) << run.err;
  const auto wrong = mapconv({"info", dir.path("a.txt"), "--columns", "time,x,y"});
  std::ofstream(dir.path("a.ply")) << "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\n"
                                      "property int y\nproperty int z\nend_header\n1 2 3\n";
  const auto ply = mapconv({"info", dir.path("a.ply"), "--columns", "z,y,x"});
  EXPECT_EQ(0, ply.status);
  EXPECT_TRUE(contains(ply.err, "--columns")) << ply.err;
  EXPECT_TRUE(contains(ply.err, "a.ply is no text of points")) << ply.err;
  EXPECT_TRUE(contains(wrong.err, "columns = time,x,y is not valid: it must name x, y and z"));
}
