#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/opengl/CMesh.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include "FreeSpaceMapFixtures.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::maps::CMultiMetricMap;

namespace
{
/** A map with no option left at its default. */
CFreeSpaceGridMap2D unusualMap()
{
  CFreeSpaceGridMap2D map(0.2);
  freespace::TConversionOptions options;
  options.robot = freespace::Robot::Aerial;
  options.params = {0.6, 0.3, 3, 0.8, 0.4};
  map.setConversionOptions(options);
  map.voxelInsertionOptions.maxrange = 9;
  map.voxelInsertionOptions.pruning = false;
  map.voxelInsertionOptions.probHit = 0.8;
  map.voxelInsertionOptions.probMiss = 0.45;
  map.voxelInsertionOptions.occupancyThres = 0.6;
  map.voxelInsertionOptions.clampingThresMin = 0.2;
  map.voxelInsertionOptions.clampingThresMax = 0.9;
  map.voxelInsertionOptions.insert2D = false;
  map.renderingOptions = {false, true, true};
  map.genericMapParams.enableObservationLikelihood = false;
  map.likelihoodOptions.LF_stdHit = 0.123f;
  map.likelihoodOptions.LF_useSquareDist = true;
  map.likelihoodOptions.consensus_pow = 2.5f;
  map.insertionOptions.mapAltitude = 0.7f;
  map.insertionOptions.maxFreenessUpdateCertainty = 0.77f;
  map.insertionOptions.maxFreenessInvalidRanges = 0.66f;
  for (int i = 0; i < 3; ++i)
    map.insertObservation(roomScan(i), mrpt::poses::CPose3D(0.9 * i, 0, 1));
  return map;
}

void expectSameOptions(const CFreeSpaceGridMap2D& a, const CFreeSpaceGridMap2D& b)
{
  EXPECT_EQ(a.conversionOptions().robot, b.conversionOptions().robot);
  EXPECT_EQ(a.conversionOptions().params.minClearance, b.conversionOptions().params.minClearance);
  EXPECT_EQ(a.conversionOptions().params.minOccupancy, b.conversionOptions().params.minOccupancy);
  EXPECT_EQ(a.conversionOptions().params.slopeWindow, b.conversionOptions().params.slopeWindow);
  EXPECT_EQ(a.conversionOptions().params.maxSlope, b.conversionOptions().params.maxSlope);
  EXPECT_EQ(a.conversionOptions().params.maxStep, b.conversionOptions().params.maxStep);
  EXPECT_EQ(a.voxelInsertionOptions.maxrange, b.voxelInsertionOptions.maxrange);
  EXPECT_EQ(a.voxelInsertionOptions.pruning, b.voxelInsertionOptions.pruning);
  EXPECT_EQ(a.voxelInsertionOptions.probHit, b.voxelInsertionOptions.probHit);
  EXPECT_EQ(a.voxelInsertionOptions.probMiss, b.voxelInsertionOptions.probMiss);
  EXPECT_EQ(a.voxelInsertionOptions.occupancyThres, b.voxelInsertionOptions.occupancyThres);
  EXPECT_EQ(a.voxelInsertionOptions.clampingThresMin, b.voxelInsertionOptions.clampingThresMin);
  EXPECT_EQ(a.voxelInsertionOptions.clampingThresMax, b.voxelInsertionOptions.clampingThresMax);
  EXPECT_EQ(a.voxelInsertionOptions.insert2D, b.voxelInsertionOptions.insert2D);
  EXPECT_EQ(a.renderingOptions.showFloor, b.renderingOptions.showFloor);
  EXPECT_EQ(a.renderingOptions.showCeiling, b.renderingOptions.showCeiling);
  EXPECT_EQ(a.renderingOptions.colorBySlope, b.renderingOptions.colorBySlope);
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
}

/** The next scan must give the same in both. */
void expectSameFuture(CFreeSpaceGridMap2D& a, CFreeSpaceGridMap2D& b)
{
  expectSameBits(a.layers(), b.layers());
  EXPECT_EQ(a.getRawMap(), b.getRawMap());
  EXPECT_EQ(a.isEmpty(), b.isEmpty());
  EXPECT_TRUE(a.octree() == b.octree());
  for (auto* map : {&a, &b}) map->insertObservation(roomScan(4), mrpt::poses::CPose3D(2.5, 1, 1));
  expectSameBits(a.layers(), b.layers());
  EXPECT_EQ(a.getRawMap(), b.getRawMap());
  EXPECT_TRUE(a.octree() == b.octree());
}

CFreeSpaceGridMap2D::Ptr roundTrip(const CFreeSpaceGridMap2D& map)
{
  std::vector<std::uint8_t> stream;
  mrpt::serialization::ObjectToOctetVector(&map, stream);
  mrpt::serialization::CSerializable::Ptr object;
  mrpt::serialization::OctetVectorToObject(stream, object);
  return std::dynamic_pointer_cast<CFreeSpaceGridMap2D>(object);
}
}  // namespace

TEST(CFreeSpaceGridMap2D_io, AStreamBringsBackMapAndOptionsExactly)
{
  auto map = unusualMap();
  std::vector<std::uint8_t> stream;
  mrpt::serialization::ObjectToOctetVector(&map, stream);
  mrpt::serialization::CSerializable::Ptr object;
  mrpt::serialization::OctetVectorToObject(stream, object);
  auto copy = std::dynamic_pointer_cast<CFreeSpaceGridMap2D>(object);
  ASSERT_TRUE(copy);
  expectSameOptions(map, *copy);
  expectSameFuture(map, *copy);
}

TEST(CFreeSpaceGridMap2D_io, AnEmptyMapSurvivesAsWell)
{
  CFreeSpaceGridMap2D map(0.4);
  std::vector<std::uint8_t> stream;
  mrpt::serialization::ObjectToOctetVector(&map, stream);
  mrpt::serialization::CSerializable::Ptr object;
  mrpt::serialization::OctetVectorToObject(stream, object);
  auto copy = std::dynamic_pointer_cast<CFreeSpaceGridMap2D>(object);
  ASSERT_TRUE(copy);
  EXPECT_TRUE(copy->isEmpty());
  EXPECT_EQ(copy->octree().getResolution(), 0.4);
  expectSameFuture(map, *copy);
}

TEST(CFreeSpaceGridMap2D_io, CopiedInsideAMultiMetricMapItGoesOnAlike)
{
  CMultiMetricMap original;
  original.maps.push_back(std::make_shared<CFreeSpaceGridMap2D>(unusualMap()));
  CMultiMetricMap copy(original);  // MRPT copies by serializing
  auto a = original.mapByClass<CFreeSpaceGridMap2D>(), b = copy.mapByClass<CFreeSpaceGridMap2D>();
  ASSERT_TRUE(a && b);
  ASSERT_NE(a, b);
  expectSameOptions(*a, *b);
  expectSameFuture(*a, *b);
}

TEST(CFreeSpaceGridMap2D_io, ATruncatedStreamThrowsAndLeavesTheMapAsItWas)
{
  const auto source = unusualMap();
  mrpt::io::CMemoryStream whole;
  mrpt::serialization::archiveFrom(whole) << source;
  const auto size = whole.getTotalBytesCount();
  ASSERT_GT(size, 2000u);

  CFreeSpaceGridMap2D target(0.25);
  target.insertObservation(roomScan(1), mrpt::poses::CPose3D(0, 0, 1));
  const auto before = target.layers();
  for (std::uint64_t length = 0; length < size; length += length < 1500 ? 7 : size / 23)
  {
    mrpt::io::CMemoryStream part;
    part.assignMemoryNotOwn(whole.getRawBufferData(), length);
    auto archive = mrpt::serialization::archiveFrom(part);
    EXPECT_ANY_THROW(archive >> target) << length;
    expectSameBits(target.layers(), before);
    EXPECT_EQ(target.octree().getResolution(), 0.25);
  }
}

TEST(CFreeSpaceGridMap2D_io, AForeignOrDamagedStreamThrowsAndLeavesTheMapAsItWas)
{
  const auto target0 = unusualMap();
  CFreeSpaceGridMap2D other(0.4);
  other.insertObservation(roomScan(2), mrpt::poses::CPose3D(0, 0, 1));
  mrpt::io::CMemoryStream whole;
  mrpt::serialization::archiveFrom(whole) << other;
  const auto* bytes = static_cast<const std::uint8_t*>(whole.getRawBufferData());
  const std::string good(bytes, bytes + whole.getTotalBytesCount());

  std::vector<std::string> bad;
  mrpt::io::CMemoryStream foreign;
  mrpt::serialization::archiveFrom(foreign) << mrpt::maps::COccupancyGridMap2D();
  const auto* foreignBytes = static_cast<const std::uint8_t*>(foreign.getRawBufferData());
  bad.emplace_back(foreignBytes, foreignBytes + foreign.getTotalBytesCount());
  const auto replaced = [&](const std::string& from, const std::string& to)
  {
    const auto at = good.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return std::string(good).replace(at, from.size(), to);
  };
  bad.push_back(replaced("id OcTree\n", "id OcTrex\n"));
  bad.push_back(replaced("res 0.4\n", "res 0.5\n"));
  const auto version = good.find("CFreeSpaceGridMap2D") + std::string("CFreeSpaceGridMap2D").size();
  auto newer = good;
  newer[version] = 77;
  bad.push_back(newer);

  for (std::size_t i = 0; i < bad.size(); ++i)
  {
    SCOPED_TRACE(i);
    auto target = target0;
    mrpt::io::CMemoryStream memory;
    memory.assignMemoryNotOwn(bad[i].data(), bad[i].size());
    auto archive = mrpt::serialization::archiveFrom(memory);
    EXPECT_ANY_THROW(archive >> target);
    auto reference = target0;
    expectSameOptions(target, reference);
    expectSameFuture(target, reference);
  }
}

TEST(CFreeSpaceGridMap2D_io, AnOddResolutionSurvives)
{
  for (const double resolution : {1.0 / 3, 0.1234567, 0.07})
  {
    CFreeSpaceGridMap2D map(resolution);
    map.insertObservation(roomScan(0), mrpt::poses::CPose3D(20, -20, 1));
    auto copy = roundTrip(map);
    EXPECT_EQ(copy->octree().getResolution(), resolution);
    expectSameFuture(map, *copy);
  }
}

TEST(CFreeSpaceGridMap2D_io, TheTreesSensorModelSurvivesOptionsThatWaitForTheNextScan)
{
  CFreeSpaceGridMap2D map(0.2);
  map.insertObservation(roomScan(0), mrpt::poses::CPose3D(0, 0, 1));
  map.voxelInsertionOptions.occupancyThres = 0.9;
  auto copy = roundTrip(map);
  EXPECT_EQ(copy->octree().getOccupancyThresLog(), map.octree().getOccupancyThresLog());
  expectSameFuture(map, *copy);
}

TEST(CFreeSpaceGridMap2D_io, ATreeWithExtremeClampingCanBeExtendedAndCopied)
{
  octomap::OcTree tree(0.2);
  tree.setClampingThresMin(0);
  tree.setClampingThresMax(1);
  column(tree, 0, 0, 0, 'f', 10);
  CFreeSpaceGridMap2D map;
  map.setVoxelMap(tree);
  EXPECT_TRUE(map.insertObservation(roomScan(0), mrpt::poses::CPose3D(0, 0, 1)));
  auto copy = roundTrip(map);
  expectSameFuture(map, *copy);
}

TEST(CFreeSpaceGridMap2D_io, UnknownFreeFollowsTheMapsHighestVoxelAndSurvives)
{
  octomap::OcTree tree(0.2);
  column(tree, 0, 0, 0, '#', 1);
  column(tree, 3, 0, 9, '#', 1);
  CFreeSpaceGridMap2D map;
  auto options = map.conversionOptions();
  options.params.reading.unknown = voxel::Unknown::Free;
  map.setConversionOptions(options);
  map.setVoxelMap(tree);
  const auto ceiling = [&map]
  {
    const auto layers = map.exactLayers();
    return layers.ceiling.cells()[layers.frame().indexOfKey(0, 0)];
  };
  EXPECT_NEAR(2.0, ceiling(), 1e-6);
  EXPECT_TRUE(map.insertObservation(roomScan(0), mrpt::poses::CPose3D(0, 0, 1)));
  EXPECT_LT(3.0, ceiling());
  auto copy = roundTrip(map);
  ASSERT_TRUE(copy);
  EXPECT_EQ(voxel::Unknown::Free, copy->conversionOptions().params.reading.unknown);
  expectSameFuture(map, *copy);
}

TEST(CFreeSpaceGridMap2D_io, AFileLeavesTheSensorModelOfTheOptions)
{
  const TempDir dir;
  octomap::OcTree tree(0.2);
  column(tree, 0, 0, 0, 'f', 10);
  ASSERT_TRUE(tree.writeBinary(dir.file("m.bt")));
  CFreeSpaceGridMap2D map;
  map.voxelInsertionOptions.probHit = 0.9;
  map.voxelInsertionOptions.occupancyThres = 0.7;
  map.loadVoxelMap(dir.file("m.bt"));
  EXPECT_EQ(map.voxelInsertionOptions.probHit, 0.9);
  EXPECT_EQ(map.voxelInsertionOptions.occupancyThres, 0.7);
  EXPECT_NEAR(map.octree().getOccupancyThres(), 0.7, 1e-6);
}

TEST(CFreeSpaceGridMap2D_io, SavesEveryLayerAndTheVoxels)
{
  const TempDir dir;
  const auto map = unusualMap();
  map.saveMetricMapRepresentationToFile(dir.file("m"));
  for (const char* name : {"m.png", "m_layers.tif", "m_floor.png", "m_ceiling.png", "m_slope.png",
                           "m_aerial.png", "m_ground.png", "m.ot"})
    EXPECT_TRUE(std::filesystem::exists(dir.file(name))) << name;
  const auto layers = map.exactLayers();
  for (const auto& [name, layer] : layers.named())
  {
    const auto band = grid::readGeoTiffBand(dir.file("m_layers.tif"), name);
    ASSERT_EQ(band.frame(), layers.frame()) << name;
    for (std::size_t i = 0; i < band.cells().size(); ++i)
      ASSERT_TRUE(band.cells()[i] == layer->cells()[i] ||
                  (std::isnan(band.cells()[i]) && std::isnan(layer->cells()[i])))
          << name << ' ' << i;
  }
  CFreeSpaceGridMap2D again(1.0);
  again.loadVoxelMap(dir.file("m.ot"));
  EXPECT_TRUE(again.octree() == map.octree());
}

TEST(CFreeSpaceGridMap2D_io, ASaveThatFailsLeavesNoFileBehind)
{
  const TempDir dir;
  writeBytes(dir.file("m.ot"), "older");
  std::filesystem::create_directory(dir.file("m_slope.png"));  // cannot be replaced by a file
  writeBytes(dir.file("m_slope.png/x"), "");
  EXPECT_THROW(unusualMap().saveMetricMapRepresentationToFile(dir.file("m")), std::exception);
  EXPECT_EQ(readBytes(dir.file("m.ot")), "older");
  EXPECT_ANY_THROW(unusualMap().saveMetricMapRepresentationToFile("/proc/nowhere/m"));
}

TEST(CFreeSpaceGridMap2D_io, DrawsFloorCeilingAndGrid)
{
  auto map = unusualMap();
  map.renderingOptions = {};
  mrpt::opengl::CSetOfObjects scene;
  map.getVisualizationInto(scene);
  EXPECT_TRUE(scene.getByName("floor"));
  EXPECT_TRUE(scene.getByName("occupancy"));
  EXPECT_FALSE(scene.getByName("ceiling"));
  const auto box =
      std::dynamic_pointer_cast<mrpt::opengl::CMesh>(scene.getByName("floor"))->getBoundingBox();
  const auto frame = map.exactLayers().frame();
  EXPECT_NEAR(box.min.x, frame.xMin() + 0.1, 1e-4);
  EXPECT_NEAR(box.max.y, frame.yMax() - 0.1, 1e-4);

  map.renderingOptions.showCeiling = true;
  mrpt::opengl::CSetOfObjects both;
  map.getVisualizationInto(both);
  EXPECT_TRUE(both.getByName("ceiling"));

  map.renderingOptions.colorBySlope = true;  // its texture must have the shape of the mesh
  mrpt::opengl::CSetOfObjects slopes;
  EXPECT_NO_THROW(map.getVisualizationInto(slopes));
  EXPECT_TRUE(slopes.getByName("floor"));

  map.genericMapParams.enableSaveAs3DObject = false;
  mrpt::opengl::CSetOfObjects nothing;
  map.getVisualizationInto(nothing);
  EXPECT_TRUE(nothing.empty());
}
