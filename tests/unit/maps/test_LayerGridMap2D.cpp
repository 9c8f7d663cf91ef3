#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/system/CTimeLogger.h>
#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/maps/LayerGridMap2D.h>

#include <filesystem>
#include <future>

#include "support/ScanFixtures.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::poses::CPose3D;

namespace
{
constexpr double kCell = 0.5;  // [m]

/** Marks the cells of points as occupied, on a frame of 8 x 8 cells around the origin. */
class DotMap : public maps::LayerGridMap2D
{
 public:
  DotMap() : LayerGridMap2D("DotMap", kCell) {}

  bool isValid = true, wants2D = false, shownAnew = false;
  std::string whySkip;

  std::vector<grid::StyledLayer> styledLayers() const override
  {
    return {{"dots", &m_dots, "Dots", "", grid::LayerKind::Occupancy}};
  }

 protected:
  void internal_clear() override
  {
    m_dots = {};
    showAllCells();
  }
  const grid::Layer<float>& shownLayer() const override { return m_dots; }
  void checkOptions() const override
  {
    if (!isValid) throw std::invalid_argument("not valid");
  }
  bool inserts2D() const override { return wants2D; }
  std::string insertScan(const observation::SensorPoints& scan) override
  {
    if (!whySkip.empty()) return whySkip;
    if (m_dots.frame().empty()) m_dots = {{kCell, -4, -4, 8, 8}, grid::kFree};
    voxel::ColumnSet changed;
    for (const auto& p : scan.points)
    {
      const auto x = grid::cellKey(p.x, kCell), y = grid::cellKey(p.y, kCell);
      m_dots.cells()[m_dots.frame().indexOfKey(x, y)] = 1;
      changed.insert(x, y);
    }
    shownAnew = showCells(changed);
    return "";
  }

 private:
  grid::Layer<float> m_dots;
};

mrpt::obs::CObservationPointCloud dots(std::initializer_list<std::pair<float, float>> places)
{
  auto cloud = mrpt::maps::CSimplePointsMap::Create();
  for (const auto& [x, y] : places) cloud->insertPoint(x, y, 0.5f);
  mrpt::obs::CObservationPointCloud scan;
  scan.pointcloud = cloud;
  scan.sensorLabel = "LIDAR";
  return scan;
}

mrpt::obs::CObservation2DRangeScan ray()
{
  mrpt::obs::CObservation2DRangeScan scan;
  scan.resizeScan(1);
  scan.setScanRange(0, 1.2f);
  scan.setScanRangeValidity(0, true);
  return scan;
}

DotMap oneDot()
{
  DotMap map;
  EXPECT_TRUE(map.insertObservation(dots({{0.7f, 0.2f}}), CPose3D()));
  return map;
}

void expectOneDot(const mrpt::maps::COccupancyGridMap2D& map)
{
  ASSERT_EQ(map.getSizeX(), 8u);
  ASSERT_EQ(map.getSizeY(), 8u);
  EXPECT_EQ(map.getXMin(), -2);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      EXPECT_EQ(map.getRow(y)[x], x == 5 && y == 4 ? -127 : 127) << x << ' ' << y;
}
}  // namespace

TEST(LayerGridMap2D, BeginsSmallUnknownAndEmpty)
{
  const DotMap map;
  EXPECT_EQ(map.getSizeX(), 20u);
  EXPECT_FLOAT_EQ(map.getResolution(), 0.5f);
  EXPECT_TRUE(map.isEmpty());
  EXPECT_EQ(map.cellSize(), kCell);
}

TEST(LayerGridMap2D, ShowsTheLayer)
{
  auto map = oneDot();
  expectOneDot(map);
  EXPECT_FALSE(map.isEmpty());
  EXPECT_TRUE(map.shownAnew);
  map.insertObservation(dots({{-1.2f, 0.2f}}), CPose3D());
  EXPECT_FALSE(map.shownAnew) << "only the changed cells";
  EXPECT_EQ(map.getRow(4)[1], -127);
  map.clear();
  EXPECT_TRUE(map.isEmpty());
  EXPECT_EQ(map.getSizeX(), 20u);
}

TEST(LayerGridMap2D, SaysWhyNothingWasInserted)
{
  DotMap map;
  std::vector<std::string> texts;
  map.log().logRegisterCallback([&texts](std::string_view text, mrpt::system::VerbosityLevel,
                                         std::string_view, const mrpt::Clock::time_point)
                                { texts.emplace_back(text); });
  EXPECT_FALSE(map.insertObservation(mrpt::obs::CObservationOdometry(), CPose3D()));
  EXPECT_EQ(map.lastSkip(), "it is not a scan");
  EXPECT_FALSE(map.insertObservation(ray(), CPose3D()));
  EXPECT_EQ(map.lastSkip(), "it is a 2D scan, and those are not inserted");
  EXPECT_TRUE(texts.empty()) << "these are not for the map";

  EXPECT_FALSE(map.insertObservation(dots({}), CPose3D()));
  EXPECT_EQ(map.lastSkip(), "it has no usable point");
  map.whySkip = "it is too dull";
  EXPECT_FALSE(map.insertObservation(dots({{0, 0.1f}}), CPose3D()));
  EXPECT_FALSE(map.insertObservation(dots({{0, 0.1f}}), CPose3D()));
  EXPECT_EQ(map.lastSkip(), "it is too dull");
  ASSERT_EQ(texts.size(), 2u) << "once for each reason";
  EXPECT_TRUE(contains(texts[1], "'LIDAR' is skipped: it is too dull (said once)")) << texts[1];

  DotMap copy(map);
  EXPECT_EQ(copy.lastSkip(), "");
  copy.insertObservation(dots({{0, 0.1f}}), CPose3D());
  EXPECT_EQ(texts.size(), 2u) << "nor do copies repeat it";
  map.whySkip.clear();
  EXPECT_TRUE(map.insertObservation(dots({{0, 0.1f}}), CPose3D()));
  EXPECT_EQ(map.lastSkip(), "");
}

TEST(LayerGridMap2D, TwoDScansCountIfTheClassSaysSo)
{
  DotMap map;
  map.wants2D = true;
  EXPECT_TRUE(map.insertObservation(ray(), CPose3D()));
}

TEST(LayerGridMap2D, BadOptionsAreErrorsOfAnInsertion)
{
  DotMap map;
  map.isValid = false;
  EXPECT_THROW(map.insertObservation(dots({}), CPose3D()), std::invalid_argument);
  EXPECT_TRUE(map.isEmpty());
}

TEST(LayerGridMap2D, WhatALikelihoodAsksForIsNotInserted)
{
  auto map = oneDot();
  map.updateInfoChangeOnly.enabled = true;
  EXPECT_FALSE(map.insertObservation(dots({{-1.2f, 0.2f}}), CPose3D()));
  expectOneDot(map);
}

TEST(LayerGridMap2D, ANonConstMethodLaysAResizedGridOutAnew)
{
  auto map = oneDot();
  map.resizeGrid(-50, 50, -50, 50);
  map.auxParticleFilterCleanUp();
  expectOneDot(map);
  map.setSize(-50, 50, -50, 50, 0.5f);
  map.insertObservation(dots({{0.7f, 0.2f}}), CPose3D());
  EXPECT_TRUE(map.shownAnew);
  expectOneDot(map);
}

TEST(LayerGridMap2D, ACopyOfAResizedGridIsLaidOutAnewAndTheGridLeftAlone)
{
  auto map = oneDot();
  map.setSize(-50, 50, -50, 50, 0.5f);
  std::vector<std::future<void>> copies;
  copies.reserve(4);
  for (int i = 0; i < 4; ++i)
    copies.push_back(std::async(std::launch::async, [&map] { expectOneDot(DotMap(map)); }));
  for (auto& copy : copies) copy.get();
  DotMap assigned;
  assigned = map;
  expectOneDot(assigned);
  EXPECT_EQ(map.getSizeX(), 200u);
}

TEST(LayerGridMap2D, AResizedGridIsSavedAsItsLayerIs)
{
  const TempDir dir;
  auto map = oneDot();
  map.saveMetricMapRepresentationToFile(dir.file("a"));
  map.resizeGrid(-50, 50, -50, 50);
  map.saveMetricMapRepresentationToFile(dir.file("b"));
  EXPECT_TRUE(readBytes(dir.file("a.png")) == readBytes(dir.file("b.png")));
  EXPECT_EQ(readBytes(dir.file("a_limits.txt")), readBytes(dir.file("b_limits.txt")));
}

TEST(LayerGridMap2D, AGridFilledFromOutsideIsLeftAloneWhileNothingIsKnown)
{
  DotMap average;
  average.setSize(-5, 5, -5, 5, 0.5f);
  average.setCell(3, 3, 0.9f);
  average.auxParticleFilterCleanUp();
  EXPECT_EQ(average.getSizeX(), 20u);
  EXPECT_GT(average.getCell(3, 3), 0.8f);
  EXPECT_GT(DotMap(average).getCell(3, 3), 0.8f);
}

TEST(LayerGridMap2D, IsSavedWithItsLayersAndTimes)
{
  const TempDir dir;
  oneDot().saveMetricMapRepresentationToFile(dir.file("m"));
  for (const char* name : {"m.png", "m_limits.txt", "m_layers.tif", "m_dots.png", "m_times.csv"})
    EXPECT_TRUE(std::filesystem::exists(dir.file(name))) << name;
  DotMap().saveMetricMapRepresentationToFile(dir.file("none"));
  EXPECT_TRUE(std::filesystem::exists(dir.file("none.png")));
  EXPECT_FALSE(std::filesystem::exists(dir.file("none_layers.tif")));
  EXPECT_FALSE(std::filesystem::exists(dir.file("none_times.csv")));
}

TEST(LayerGridMap2D, IsDrawnUnlessThatIsSwitchedOff)
{
  auto map = oneDot();
  mrpt::opengl::CSetOfObjects scene, nothing;
  map.getVisualizationInto(scene);
  EXPECT_TRUE(scene.getByName("occupancy"));
  map.genericMapParams.enableSaveAs3DObject = false;
  map.getVisualizationInto(nothing);
  DotMap().getVisualizationInto(nothing);
  EXPECT_TRUE(nothing.empty());
}

TEST(LayerGridMap2D, EachObjectTimesItsOwnInsertions)
{
  const auto map = oneDot();
  std::map<std::string, mrpt::system::CTimeLogger::TCallStats> stats;
  map.insertionTimes().getStats(stats);
  EXPECT_EQ(stats["insert"].n_calls, 1u);
  DotMap(map).insertionTimes().getStats(stats);
  EXPECT_TRUE(stats.empty());
}

TEST(LayerGridMap2D, ResolutionsThatMrptCannotHoldAreRefused)
{
  struct FineMap : DotMap
  {
    void refine(double resolution) { setCellSize(resolution); }
  };
  FineMap map;
  EXPECT_THROW(map.refine(1e-5), std::invalid_argument);
  EXPECT_EQ(map.cellSize(), kCell);
}
