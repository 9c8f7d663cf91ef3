#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/TMetricMapInitializer.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include "ScanShapeFixtures.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::maps::CMultiMetricMap;
using mrpt::maps::TSetOfMetricMapInitializers;
using mrpt::poses::CPose3D;

namespace
{
const CPose3D kNextPose(2.5, 1, 0, 0.4, 0, 0);

/** A map with no option left at its default. */
CScanShapeGridMap2D unusualMap()
{
  auto map = mapForRooms(0.07);
  map.maxGridCells = 1e6;
  map.scanInsertionOptions.profile = {
      scan::Model::ClosestPoint, 0.1, 1.4, true, 1.9, 2.3, 0.4, 9, 720, 0.02, 0.15};
  map.scanInsertionOptions.update = {0.8, 0.4, 0.05, 0.95};
  map.scanInsertionOptions.insert2D = false;
  map.genericMapParams.enableObservationLikelihood = false;
  map.likelihoodOptions.LF_stdHit = 0.123f;
  map.likelihoodOptions.LF_useSquareDist = true;
  map.likelihoodOptions.consensus_pow = 2.5f;
  map.insertionOptions.mapAltitude = 0.7f;
  map.insertionOptions.maxFreenessUpdateCertainty = 0.77f;
  map.insertionOptions.maxFreenessInvalidRanges = 0.66f;
  map.insertionOptions.wideningBeamsWithDistance = true;
  for (int i = 0; i < 3; ++i)
  {
    const CPose3D robot(0.7 * i, 0, 0, 0.2 * i, 0, 0);
    EXPECT_TRUE(map.insertObservation(scanOf(Room{-4.3, 4.1, -3, 5.2, 2.5}, robot), robot));
  }
  return map;
}

void expectSameOptions(const CScanShapeGridMap2D& a, const CScanShapeGridMap2D& b)
{
  mrpt::io::CMemoryStream left, right;  // all of them, bit by bit
  auto leftArchive = mrpt::serialization::archiveFrom(left);
  auto rightArchive = mrpt::serialization::archiveFrom(right);
  a.scanInsertionOptions.writeToStream(leftArchive);
  b.scanInsertionOptions.writeToStream(rightArchive);
  ASSERT_EQ(left.getTotalBytesCount(), right.getTotalBytesCount());
  EXPECT_EQ(
      std::memcmp(left.getRawBufferData(), right.getRawBufferData(), left.getTotalBytesCount()), 0);
  EXPECT_EQ(a.maxGridCells, b.maxGridCells);
  EXPECT_EQ(a.genericMapParams.enableObservationLikelihood,
            b.genericMapParams.enableObservationLikelihood);
  EXPECT_EQ(a.likelihoodOptions.LF_stdHit, b.likelihoodOptions.LF_stdHit);
  EXPECT_EQ(a.likelihoodOptions.LF_useSquareDist, b.likelihoodOptions.LF_useSquareDist);
  EXPECT_EQ(a.likelihoodOptions.consensus_pow, b.likelihoodOptions.consensus_pow);
  EXPECT_EQ(a.insertionOptions.mapAltitude, b.insertionOptions.mapAltitude);
  EXPECT_EQ(a.insertionOptions.maxFreenessUpdateCertainty,
            b.insertionOptions.maxFreenessUpdateCertainty);
  EXPECT_EQ(a.insertionOptions.maxFreenessInvalidRanges,
            b.insertionOptions.maxFreenessInvalidRanges);
  EXPECT_EQ(a.insertionOptions.wideningBeamsWithDistance,
            b.insertionOptions.wideningBeamsWithDistance);
}

void expectSameGrid(const CScanShapeGridMap2D& a, const CScanShapeGridMap2D& b)
{
  EXPECT_EQ(a.frame(), b.frame());
  EXPECT_EQ(a.getXMin(), b.getXMin());
  EXPECT_EQ(a.getXMax(), b.getXMax());
  EXPECT_EQ(a.getYMin(), b.getYMin());
  EXPECT_EQ(a.getYMax(), b.getYMax());
  EXPECT_TRUE(a.getRawMap() == b.getRawMap());
  EXPECT_EQ(a.isEmpty(), b.isEmpty());
}

/** The next scan must give the same in both. */
void expectSameFuture(CScanShapeGridMap2D& a, CScanShapeGridMap2D& b)
{
  expectSameOptions(a, b);
  expectSameGrid(a, b);
  for (auto* map : {&a, &b})
    map->insertObservation(scanOf(Room{-9, 9, -9, 9, 2.5}, kNextPose), kNextPose);
  expectSameGrid(a, b);
}

CScanShapeGridMap2D::Ptr roundTrip(const CScanShapeGridMap2D& map)
{
  mrpt::serialization::CSerializable::Ptr object;
  mrpt::serialization::OctetVectorToObject(bytes(map), object);
  return std::dynamic_pointer_cast<CScanShapeGridMap2D>(object);
}

mrpt::maps::CMetricMap::Ptr fromIni(const std::string& text)
{
  const mrpt::config::CConfigFileMemory ini("[map]\nscanShapeGrid_count=1\n" + text);
  TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(ini, "map");
  CMultiMetricMap maps;
  maps.setListOfMaps(definitions);
  return maps.maps.at(0);
}

const std::string kSlices = "structureMinZ=2\nstructureMaxZ=2.4\n";
const std::string kInsertOpts = "[map_scanShapeGrid_00_insertOpts]\n" + kSlices;

std::string streamOf(const mrpt::serialization::CSerializable& object)
{
  mrpt::io::CMemoryStream memory;
  mrpt::serialization::archiveFrom(memory) << object;
  const auto* data = static_cast<const char*>(memory.getRawBufferData());
  return {data, data + memory.getTotalBytesCount()};
}

void expectRefused(const std::string& stream, CScanShapeGridMap2D& target)
{
  const auto before = bytes(target);
  mrpt::io::CMemoryStream memory;
  memory.assignMemoryNotOwn(stream.data(), stream.size());
  auto archive = mrpt::serialization::archiveFrom(memory);
  EXPECT_ANY_THROW(archive >> target);
  EXPECT_EQ(bytes(target), before);
}
}  // namespace

TEST(CScanShapeGridMap2D_io, AStreamBringsBackMapAndOptionsExactly)
{
  auto map = unusualMap();
  auto copy = roundTrip(map);
  ASSERT_TRUE(copy);
  EXPECT_FALSE(copy->isEmpty());
  expectSameFuture(map, *copy);
}

TEST(CScanShapeGridMap2D_io, AnEmptyMapSurvivesAsWell)
{
  auto map = mapForRooms(0.4);
  auto copy = roundTrip(map);
  ASSERT_TRUE(copy);
  EXPECT_TRUE(copy->isEmpty());
  expectSameFuture(map, *copy);
}

TEST(CScanShapeGridMap2D_io, AnOddResolutionSurvives)
{
  for (const double resolution : {1.0 / 3, 0.1234567, 0.07})
  {
    auto map = mapOf(Room{-30, 9, -41, 8, 2.5}, resolution);
    auto copy = roundTrip(map);
    ASSERT_TRUE(copy);
    EXPECT_EQ(copy->frame().resolution, resolution);
    expectSameFuture(map, *copy);
  }
}

TEST(CScanShapeGridMap2D_io, AGridResizedBehindItsBackSurvivesAsItIs)
{
  auto map = mapOf(Room(), 0.07);
  map.resizeGrid(-15.3f, 17.1f, -13.7f, 14.9f);
  auto copy = roundTrip(map);
  ASSERT_TRUE(copy);
  expectSameFuture(map, *copy);
}

TEST(CScanShapeGridMap2D_io, CopiedInsideAMultiMetricMapItGoesOnAlike)
{
  CMultiMetricMap original;
  original.maps.push_back(std::make_shared<CScanShapeGridMap2D>(unusualMap()));
  CMultiMetricMap copy(original);
  auto a = original.mapByClass<CScanShapeGridMap2D>(), b = copy.mapByClass<CScanShapeGridMap2D>();
  ASSERT_TRUE(a && b);
  ASSERT_NE(a, b);
  expectSameFuture(*a, *b);
}

TEST(CScanShapeGridMap2D_io, ATruncatedStreamThrowsAndLeavesTheMapAsItWas)
{
  const std::string whole = streamOf(unusualMap());
  ASSERT_GT(whole.size(), 2000u);
  auto target = mapOf(Room(), 0.25);
  for (std::size_t length = 0; length < whole.size(); length += whole.size() / 97)
    expectRefused(whole.substr(0, length), target);
  for (std::size_t length = whole.size() - 300; length < whole.size(); length += 7)
    expectRefused(whole.substr(0, length), target);
}

TEST(CScanShapeGridMap2D_io, AForeignOrNewerStreamThrowsAndLeavesTheMapAsItWas)
{
  auto target = unusualMap();
  expectRefused(streamOf(mrpt::maps::COccupancyGridMap2D()), target);
  auto newer = streamOf(mapOf(Room()));
  const std::string name = "CScanShapeGridMap2D";
  newer[newer.find(name) + name.size()] = 77;
  expectRefused(newer, target);
}

TEST(CScanShapeGridMap2D_io, IsMadeFromIniUnderBothNames)
{
  const std::string sections =
      "[map_scanShapeGrid_00_creationOpts]\nresolution=0.3\nmaxGridCells=1e6\n"
      "enableObservationLikelihood=false\n" +
      kInsertOpts +
      "model=closestPoint\nmaxRange=7\ninsert2D=false\nmaxDistanceInsertion=12\n"
      "horizontalTolerance=2\n"
      "[map_scanShapeGrid_00_likelihoodOpts]\nlikelihoodMethod=lmConsensus\nLF_stdHit=0.11\n";
  const auto map = std::dynamic_pointer_cast<CScanShapeGridMap2D>(fromIni(sections));
  ASSERT_TRUE(map);
  EXPECT_EQ(map->frame().resolution, 0.3);
  EXPECT_EQ(map->maxGridCells, 1e6);
  EXPECT_FALSE(map->genericMapParams.enableObservationLikelihood);
  EXPECT_EQ(map->scanInsertionOptions.profile.model, scan::Model::ClosestPoint);
  EXPECT_EQ(map->scanInsertionOptions.profile.maxRange, 7);
  EXPECT_EQ(map->scanInsertionOptions.profile.structureMinZ, 2);
  EXPECT_FALSE(map->scanInsertionOptions.insert2D);
  EXPECT_EQ(map->insertionOptions.maxDistanceInsertion, 12);
  EXPECT_FLOAT_EQ(map->insertionOptions.horizontalTolerance, mrpt::DEG2RAD(2.0f));
  EXPECT_EQ(map->likelihoodOptions.likelihoodMethod, mrpt::maps::COccupancyGridMap2D::lmConsensus);
  EXPECT_EQ(map->likelihoodOptions.LF_stdHit, 0.11f);

  const std::string longName = "mrpt_mapconv::CScanShapeGridMap2D";
  const mrpt::config::CConfigFileMemory ini("[map]\n" + longName + "_count=1\n[map_" + longName +
                                            "_00_insertOpts]\n" + kSlices);
  TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(ini, "map");
  EXPECT_EQ(definitions.size(), 1u);
}

TEST(CScanShapeGridMap2D_io, ABadIniValueIsAnErrorThatNamesIt)
{
  for (const auto& [section, line] : std::vector<std::pair<std::string, std::string>>{
           {"creationOpts", "resolution=0"},
           {"creationOpts", "resolution=tiny"},
           {"creationOpts", "resolution=1e300"},
           {"creationOpts", "maxGridCells=0"},
           {"creationOpts", "maxGridCells=many"},
           {"creationOpts", "enableSaveAs3DObject=maybe"},
           {"insertOpts", "maxRange=1,5"},
           {"insertOpts", "model=nearest"},
           {"insertOpts", "maxDistanceInsertion=0"},
           {"insertOpts", "maxDistanceInsertion=far"},
           {"insertOpts", "maxOccupancyUpdateCertainty=0.4"},
           {"insertOpts", "maxOccupancyUpdateCertainty=1.1"},
           {"insertOpts", "maxFreenessUpdateCertainty=0.3"},
           {"insertOpts", "maxFreenessInvalidRanges=2"},
           {"insertOpts", "considerInvalidRangesAsFreeSpace=perhaps"},
           {"insertOpts", "decimation=0"},
           {"insertOpts", "decimation=65536"},
           {"insertOpts", "horizontalTolerance=-1"},
           {"insertOpts", "mapAltitude=1,5"},
           {"insertOpts", "wideningBeamsWithDistance=2"},
           {"likelihoodOpts", "LF_decimation=0"},
           {"likelihoodOpts", "likelihoodMethod=lmBanana"}})
  {
    const auto key = line.substr(0, line.find('=')), value = line.substr(line.find('=') + 1);
    const std::string name = "[map_scanShapeGrid_00_" + section + "]\n";
    const std::string slices = section == "insertOpts" ? kSlices : "";
    const std::string others = section == "insertOpts" ? "" : kInsertOpts;
    try
    {
      fromIni(others + name + slices + line + "\n");
      ADD_FAILURE() << line << " is accepted";
    }
    catch (const std::exception& error)
    {
      const std::string message = error.what();
      EXPECT_TRUE(contains(message, "section 'map_scanShapeGrid_00_" + section + "'")) << message;
      EXPECT_TRUE(contains(message, key)) << message;
      EXPECT_TRUE(contains(message, value.substr(0, 4))) << message;
    }
  }
}

TEST(CScanShapeGridMap2D_io, TheReflectionFilterNeedsItsSliceInTheIni)
{
  try
  {
    fromIni("");
    ADD_FAILURE() << "no exception";
  }
  catch (const std::exception& error)
  {
    const std::string message = error.what();
    EXPECT_TRUE(contains(message, "section 'map_scanShapeGrid_00_insertOpts'")) << message;
    EXPECT_TRUE(contains(message, "structureMinZ is missing")) << message;
  }
  EXPECT_TRUE(fromIni("[map_scanShapeGrid_00_insertOpts]\nreflectionFilter=false\n"));
}

/** Not only at the first scan. */
TEST(CScanShapeGridMap2D_io, CellsTooFineForTheRangeAreAnErrorOfTheIni)
{
  const std::string creation = "[map_scanShapeGrid_00_creationOpts]\nresolution=";
  try
  {
    fromIni(kInsertOpts + creation + "0.001\n");
    ADD_FAILURE() << "no exception";
  }
  catch (const std::exception& error)
  {
    const std::string message = error.what();
    EXPECT_TRUE(contains(message,
                         "section 'map_scanShapeGrid_00_insertOpts': maxRange = 20 is not valid: "
                         "with resolution = 0.001 m it must be at most 10 m (10000 cells)"))
        << message;
  }
  EXPECT_TRUE(fromIni(kInsertOpts + "maxRange=9.9\n" + creation + "0.001\n"));
}

TEST(CScanShapeGridMap2D_io, UnknownKeysAndSectionsAreNamedInOneWarningEach)
{
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  fromIni(
      kInsertOpts +
      "maxrange=7\nmaxDistanceInsertion=9\n[map_scanShapeGrid_00_conversionOpts]\nrobot=aerial\n"
      "[map_scanShapeGrid_00_creationOpts]\nmin_x=7\n");
  const auto said = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  EXPECT_TRUE(contains(said, "unknown key 'maxrange' has no effect")) << said;
  EXPECT_TRUE(contains(said, "unknown key 'min_x' has no effect")) << said;
  EXPECT_TRUE(contains(said, "map_scanShapeGrid_00_conversionOpts")) << said;
  EXPECT_FALSE(contains(said, "maxDistanceInsertion")) << said;
  EXPECT_FALSE(contains(said, "structureMinZ")) << said;
}

TEST(CScanShapeGridMap2D_io, SavesTheProbabilities)
{
  const TempDir dir;
  const auto map = unusualMap();
  map.saveMetricMapRepresentationToFile(dir.file("m"));
  for (const char* name : {"m.png", "m_limits.txt", "m_occupancy.tif"})
    EXPECT_TRUE(std::filesystem::exists(dir.file(name))) << name;
  const auto band = grid::readGeoTiffBand(dir.file("m_occupancy.tif"), "occupancy");
  const auto expected = map.probability();
  ASSERT_EQ(band.frame(), expected.frame());
  std::size_t known = 0;
  for (std::size_t i = 0; i < band.cells().size(); ++i)
  {
    const float cell = band.cells()[i];
    ASSERT_TRUE(cell == expected.cells()[i] ||
                (std::isnan(cell) && std::isnan(expected.cells()[i])))
        << i;
    known += std::isnan(cell) ? 0 : 1;
  }
  EXPECT_GT(known, 1000u);
}

TEST(CScanShapeGridMap2D_io, ASaveThatFailsLeavesNoFileBehind)
{
  const TempDir dir;
  writeBytes(dir.file("m.png"), "older");
  std::filesystem::create_directory(dir.file("m_limits.txt"));  // cannot be replaced by a file
  writeBytes(dir.file("m_limits.txt/x"), "");
  EXPECT_THROW(unusualMap().saveMetricMapRepresentationToFile(dir.file("m")), std::exception);
  EXPECT_EQ(readBytes(dir.file("m.png")), "older");
  EXPECT_FALSE(std::filesystem::exists(dir.file("m_occupancy.tif")));
  EXPECT_ANY_THROW(unusualMap().saveMetricMapRepresentationToFile("/proc/nowhere/m"));
}

TEST(CScanShapeGridMap2D_io, DrawsItsGridOnRequest)
{
  auto map = mapOf(Room());
  mrpt::opengl::CSetOfObjects scene;
  map.getVisualizationInto(scene);
  ASSERT_FALSE(scene.empty());
  const auto box = scene.getBoundingBox();
  EXPECT_NEAR(box.min.x, map.getXMin(), 1e-4);
  EXPECT_NEAR(box.max.y, map.getYMax(), 1e-4);

  mrpt::opengl::CSetOfObjects nothing;
  map.genericMapParams.enableSaveAs3DObject = false;
  map.getVisualizationInto(nothing);
  CScanShapeGridMap2D().getVisualizationInto(nothing);
  EXPECT_TRUE(nothing.empty());
}
