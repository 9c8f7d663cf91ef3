#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/system/CTimeLogger.h>
#include <mrpt_mapconv/grid/GridMap.h>

#include <future>
#include <sstream>
#include <utility>

#include "FreeSpaceMapFixtures.h"

// What MRPT's SLAM programs do to the map: copies, grids resized behind its back, timed insertions.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;

namespace
{
const mrpt::poses::CPose3D kOneMetreUp(0, 0, 1);

CFreeSpaceGridMap2D roomMap()
{
  CFreeSpaceGridMap2D map(0.1);
  map.insertObservation(roomScan(0), kOneMetreUp);
  return map;
}

void expectGridOfLayers(const CFreeSpaceGridMap2D& map)
{
  const auto& frame = map.layers().frame();
  ASSERT_EQ(map.getSizeX(), static_cast<unsigned>(frame.width));
  ASSERT_EQ(map.getSizeY(), static_cast<unsigned>(frame.height));
  mrpt::maps::COccupancyGridMap2D right;
  grid::copyToGridMap(map.layers().ground, right);
  EXPECT_TRUE(map.getRawMap() == right.getRawMap());
}

/** The history of one quantity in a logger's file. */
std::vector<double> historyOf(const mrpt::system::CTimeLogger& times, const std::string& name)
{
  const TempDir dir;
  times.saveToCSVFile(dir.file("times.csv"));
  std::istringstream lines(readBytes(dir.file("times.csv")));
  std::vector<double> history;
  for (std::string line; std::getline(lines, line);)
  {
    if (line.rfind("\"" + name + "\",", 0) != 0) continue;
    std::istringstream fields(line);
    std::string field;
    for (int i = 0; std::getline(fields, field, ',');)
      if (++i > 7) history.push_back(std::stod(field));
  }
  return history;
}
}  // namespace

TEST(CFreeSpaceGridMap2DInSlam, AResizedGridIsLaidOutAnewBeforeTheNextInsertion)
{
  auto map = roomMap();
  auto twin = map;
  map.resizeGrid(-50, 50, -50, 50);
  map.insertObservation(roomScan(-1), kOneMetreUp);
  twin.insertObservation(roomScan(-1), kOneMetreUp);
  EXPECT_EQ(map.layers().frame(), twin.layers().frame());  // so that this is not the reason
  expectGridOfLayers(map);
  EXPECT_TRUE(map.getRawMap() == twin.getRawMap());
}

TEST(CFreeSpaceGridMap2DInSlam, AResizedGridIsLaidOutAnewAtTheEndOfAFilterStep)
{
  auto map = roomMap();
  map.resizeGrid(-50, 50, -50, 50);
  ASSERT_NE(map.getSizeX(), static_cast<unsigned>(map.layers().frame().width));
  map.auxParticleFilterCleanUp();
  expectGridOfLayers(map);
}

TEST(CFreeSpaceGridMap2DInSlam, AnErasedGridIsMatchedWithAsItsLayersAre)
{
  auto map = roomMap();
  mrpt::maps::CSimplePointsMap points;
  for (int i = -20; i <= 20; ++i) points.insertPoint(3, 0.1f * static_cast<float>(i), 0);
  mrpt::maps::TMatchingParams params;
  params.maxDistForCorrespondence = 0.3f;
  const auto matches = [&](const CFreeSpaceGridMap2D& matched)
  {
    mrpt::tfest::TMatchingPairList pairs;
    mrpt::maps::TMatchingExtraResults extra;
    matched.determineMatching2D(&points, {}, pairs, params, extra);
    return pairs.size();
  };
  const auto right = matches(map);
  EXPECT_GT(right, 10u);
  map.setSize(-20, 20, -20, 20, 0.1f);
  EXPECT_EQ(matches(map), right);
  EXPECT_EQ(map.getSizeX(), 400u) << "matching is const: the grid is laid out for it only";
}

TEST(CFreeSpaceGridMap2DInSlam, AResizedGridIsSavedAsItsLayersAre)
{
  const TempDir dir;
  auto map = roomMap();
  map.saveMetricMapRepresentationToFile(dir.file("before"));
  map.resizeGrid(-50, 50, -50, 50);
  map.saveMetricMapRepresentationToFile(dir.file("after"));
  EXPECT_TRUE(readBytes(dir.file("before.png")) == readBytes(dir.file("after.png")));
  EXPECT_EQ(readBytes(dir.file("before_limits.txt")), readBytes(dir.file("after_limits.txt")));
}

TEST(CFreeSpaceGridMap2DInSlam, NoCopyHasAResizedGrid)
{
  auto map = roomMap();
  map.resizeGrid(-50, 50, -50, 50);
  const CFreeSpaceGridMap2D copy(map);
  expectGridOfLayers(copy);
  map.resizeGrid(-50, 50, -50, 50);
  CFreeSpaceGridMap2D assigned(0.3);
  assigned = map;
  expectGridOfLayers(assigned);
}

TEST(CFreeSpaceGridMap2DInSlam, ManyThreadsCopyAResizedGridAtOnce)
{
  const auto right = roomMap().getRawMap();
  for (int round = 0; round < 20; ++round)
  {
    auto map = roomMap();
    map.resizeGrid(-50, 50, -50, 50);
    std::vector<std::future<bool>> copies;
    std::vector<const mrpt::system::CTimeLogger*> times(4);
    copies.reserve(times.size());
    for (auto& seen : times)
      copies.push_back(std::async(std::launch::async,
                                  [&map, &right, &seen]
                                  {
                                    const CFreeSpaceGridMap2D copy(map);
                                    seen = &copy.insertionTimes();
                                    seen = &std::as_const(map).insertionTimes();
                                    return copy.getRawMap() == right;
                                  }));
    for (auto& copy : copies) EXPECT_TRUE(copy.get()) << round;
    for (const auto* seen : times) EXPECT_EQ(seen, &map.insertionTimes());
  }
}

/** The average of particles' maps is written into the grid of a map that has no voxels. */
TEST(CFreeSpaceGridMap2DInSlam, AGridFilledFromOutsideIsLeftAloneWhileThereAreNoVoxels)
{
  CFreeSpaceGridMap2D average(0.1);
  average.setSize(-5, 5, -5, 5, 0.1f);
  average.setCell(50, 50, 0.9f);
  average.auxParticleFilterCleanUp();
  EXPECT_EQ(average.getSizeX(), 100u);
  EXPECT_GT(average.getCell(50, 50), 0.8f);
}

TEST(CFreeSpaceGridMap2DInSlam, AParticlesCopyIsTheSameMap)
{
  mrpt::maps::CMultiMetricMap particle;
  particle.maps.push_back(std::make_shared<CFreeSpaceGridMap2D>(roomMap()));
  const mrpt::maps::CMultiMetricMap copy(particle);
  const auto original = particle.mapByClass<CFreeSpaceGridMap2D>();
  const auto copied = copy.mapByClass<CFreeSpaceGridMap2D>();
  ASSERT_TRUE(copied);
  ASSERT_NE(copied, original);
  expectSameBits(copied->layers(), original->layers());
  EXPECT_TRUE(copied->getRawMap() == original->getRawMap());

  original->insertObservation(roomScan(1), kOneMetreUp);
  copied->insertObservation(roomScan(1), kOneMetreUp);
  expectSameBits(copied->layers(), original->layers());
}

TEST(CFreeSpaceGridMap2DInSlam, EveryInsertionIsTimed)
{
  CFreeSpaceGridMap2D map(0.1);
  map.insertObservation(roomScan(0), kOneMetreUp);
  map.insertObservation(roomScan(0), kOneMetreUp);  // makes the same voxels surer
  map.insertObservation(roomScan(1), kOneMetreUp);  // further walls: the frame must grow
  const auto& times = map.insertionTimes();

  const auto columns = historyOf(times, "insert.columns");
  ASSERT_EQ(columns.size(), 3u);
  EXPECT_GT(columns[0], 3000);  // of 60 × 60
  EXPECT_LE(columns[0], 62 * 62);
  EXPECT_EQ(columns[1], 0);
  EXPECT_EQ(historyOf(times, "insert.laidOut"), (std::vector<double>{1, 0, 1}));

  const auto whole = historyOf(times, "insert"), voxels = historyOf(times, "insert.voxels"),
             layers = historyOf(times, "insert.layers");
  ASSERT_EQ(whole.size(), 3u);
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    EXPECT_GT(voxels.at(i), 0);
    EXPECT_LE(voxels.at(i) + layers.at(i), whole[i] + 2e-6) << "the file has microseconds";
  }
}

TEST(CFreeSpaceGridMap2DInSlam, CopiesTimeTheirOwnInsertions)
{
  const auto map = roomMap();
  CFreeSpaceGridMap2D copy(map);
  EXPECT_TRUE(historyOf(copy.insertionTimes(), "insert").empty());
  copy.insertObservation(roomScan(1), kOneMetreUp);
  EXPECT_EQ(historyOf(copy.insertionTimes(), "insert").size(), 1u);
}

TEST(CFreeSpaceGridMap2DInSlam, AssigningAndReadingForgetTheTimes)
{
  auto assigned = roomMap(), read = roomMap();
  assigned = roomMap();
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << roomMap();
  stream.Seek(0);
  archive >> read;
  for (auto* map : {&assigned, &read})
  {
    EXPECT_TRUE(historyOf(map->insertionTimes(), "insert").empty());
    map->insertObservation(roomScan(1), kOneMetreUp);
    EXPECT_EQ(historyOf(map->insertionTimes(), "insert").size(), 1u);
  }
}

TEST(CFreeSpaceGridMap2DInSlam, ABadStreamLeavesTheTimes)
{
  auto map = roomMap();
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << mrpt::maps::COccupancyGridMap2D();
  stream.Seek(0);
  EXPECT_ANY_THROW(archive >> map);
  EXPECT_EQ(historyOf(map.insertionTimes(), "insert").size(), 1u);
}

TEST(CFreeSpaceGridMap2DInSlam, TimesAreSavedWithTheMap)
{
  const TempDir dir;
  roomMap().saveMetricMapRepresentationToFile(dir.file("m"));
  CFreeSpaceGridMap2D(0.1).saveMetricMapRepresentationToFile(dir.file("none"));
  EXPECT_TRUE(contains(readBytes(dir.file("m_times.csv")), "\"insert\""));
  EXPECT_FALSE(std::filesystem::exists(dir.file("none_times.csv")));
}
