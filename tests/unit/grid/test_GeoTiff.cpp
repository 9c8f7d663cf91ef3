#include <gdal.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/TempDir.h"

using namespace mrpt_mapconv::grid;
using namespace mrpt_mapconv::testing;

namespace
{
const float kNan = std::numeric_limits<float>::quiet_NaN();

Layer<float> numbered(const GridFrame& frame)
{
  Layer<float> layer(frame, 0.0f);
  for (std::size_t i = 0; i < frame.size(); ++i) layer.cells()[i] = static_cast<float>(i);
  return layer;
}

Layer<float> noise(const GridFrame& frame)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> value;
  Layer<float> layer(frame, 0.0f);
  for (float& cell : layer.cells()) cell = value(random);
  return layer;
}

/** Cells are the same, NaN equal to NaN. */
bool same(const Layer<float>& a, const Layer<float>& b)
{
  if (a.frame() != b.frame()) return false;
  for (std::size_t i = 0; i < a.cells().size(); ++i)
    if (!(a.cells()[i] == b.cells()[i] || (std::isnan(a.cells()[i]) && std::isnan(b.cells()[i]))))
      return false;
  return true;
}

/** A GeoTIFF with any geotransform and no-data value, written by GDAL alone. */
void writeForeign(const std::string& path, double* transform, const double* noData)
{
  GDALAllRegister();
  GDALDatasetH file =
      GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), 2, 1, 1, GDT_Int16, nullptr);
  if (transform) GDALSetGeoTransform(file, transform);
  GDALRasterBandH band = GDALGetRasterBand(file, 1);
  GDALSetDescription(band, "h");
  if (noData) GDALSetRasterNoDataValue(band, *noData);
  float cells[] = {5, -9};
  ASSERT_EQ(GDALRasterIO(band, GF_Write, 0, 0, 2, 1, cells, 2, 1, GDT_Float32, 0, 0), CE_None);
  GDALClose(file);
}
}  // namespace

TEST(GeoTiff, gdalReadsWhatWasWritten)
{
  const TempDir dir;
  const GridFrame frame{0.07, -31, 17, 5, 3};
  Layer<float> floor = numbered(frame), aerial(frame, -1.0f);
  floor.at(2, 1) = kNan;
  writeGeoTiff(dir.path("x.tif"), {{"floor", &floor}, {"aerial", &aerial}});
  EXPECT_EQ(dir.entries(), 1U) << "GDAL left another file";

  GDALAllRegister();
  GDALDatasetH file = GDALOpen(dir.path("x.tif").c_str(), GA_ReadOnly);
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(GDALGetRasterXSize(file), 5);
  EXPECT_EQ(GDALGetRasterYSize(file), 3);
  ASSERT_EQ(GDALGetRasterCount(file), 2);
  EXPECT_STREQ(GDALGetProjectionRef(file), "");
  double t[6];
  ASSERT_EQ(GDALGetGeoTransform(file, t), CE_None);
  const double expected[6] = {frame.xMin(), 0.07, 0, frame.yMax(), 0, -0.07};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(t[i], expected[i]) << i;

  for (int b = 1; b <= 2; ++b)
  {
    GDALRasterBandH band = GDALGetRasterBand(file, b);
    EXPECT_STREQ(GDALGetDescription(band), b == 1 ? "floor" : "aerial");
    EXPECT_EQ(GDALGetRasterDataType(band), GDT_Float32);
    int has = 0;
    EXPECT_TRUE(std::isnan(GDALGetRasterNoDataValue(band, &has)));
    EXPECT_TRUE(has);
  }
  float cells[15];
  ASSERT_EQ(
      GDALRasterIO(GDALGetRasterBand(file, 1), GF_Read, 0, 0, 5, 3, cells, 5, 3, GDT_Float32, 0, 0),
      CE_None);
  EXPECT_EQ(cells[0], 10.0f) << "the first raster row is the highest y";
  EXPECT_EQ(cells[14], 4.0f);
  EXPECT_TRUE(std::isnan(cells[7]));
  GDALClose(file);
}

TEST(GeoTiff, aLocalFrameKeepsItsOrigin)
{
  const TempDir dir;
  const GridFrame frame{0.07, -31, 17, 5, 3};
  const Layer<float> floor = numbered(frame), aerial(frame, 0);
  const GeoReference reference{{448258, 5411929, 200}, "EPSG:32633"};
  writeGeoTiff(dir.path("x.tif"),
               {{"floor", &floor}, {"aerial", &aerial, "", "", LayerKind::Occupancy}}, {},
               reference);
  EXPECT_TRUE(readGeoReference(dir.path("x.tif")) == reference);
  const auto read = readGeoTiffBand(dir.path("x.tif"), "floor");
  EXPECT_EQ(read.frame(), frame);
  EXPECT_EQ(read.at(1, 1), floor.at(1, 1));

  GDALAllRegister();
  GDALDatasetH file = GDALOpen(dir.path("x.tif").c_str(), GA_ReadOnly);
  ASSERT_NE(file, nullptr);
  double t[6];
  ASSERT_EQ(GDALGetGeoTransform(file, t), CE_None);
  EXPECT_EQ(t[0], frame.xMin() + 448258);
  EXPECT_EQ(t[3], frame.yMax() + 5411929);
  EXPECT_NE(std::string(GDALGetProjectionRef(file)).find("UTM zone 33N"), std::string::npos);
  int has = 0;
  EXPECT_EQ(GDALGetRasterOffset(GDALGetRasterBand(file, 1), &has), 200) << "heights";
  EXPECT_EQ(GDALGetRasterOffset(GDALGetRasterBand(file, 2), &has), 0);
  GDALClose(file);
}

// EPSG:2992 is Oregon in international feet, 2227 California in feet of the surveys.
TEST(GeoTiff, liesInTheUnitsOfItsCoordinateSystem)
{
  const TempDir dir;
  const GridFrame frame{0.07, -31, 17, 5, 3};
  const Layer<float> floor = numbered(frame);
  const GeoReference reference{{193851, 259000, 120}, "EPSG:2992", 0.3048};
  writeGeoTiff(dir.path("x.tif"), {{"floor", &floor}}, {}, reference);
  EXPECT_TRUE(readGeoReference(dir.path("x.tif")) == reference);
  const auto read = readGeoTiffBand(dir.path("x.tif"), "floor");
  EXPECT_EQ(read.frame(), frame) << "also the size of its cells, which a quotient rounds";
  EXPECT_EQ(read.at(1, 1), floor.at(1, 1));

  GDALAllRegister();
  GDALDatasetH file = GDALOpen(dir.path("x.tif").c_str(), GA_ReadOnly);
  ASSERT_NE(file, nullptr);
  double t[6];
  ASSERT_EQ(GDALGetGeoTransform(file, t), CE_None);
  EXPECT_NEAR(t[0], (frame.xMin() + 193851) / 0.3048, 1e-6);
  EXPECT_NEAR(t[3], (frame.yMax() + 259000) / 0.3048, 1e-6);
  EXPECT_NEAR(t[1], 0.07 / 0.3048, 1e-12);
  EXPECT_NEAR(t[5], -0.07 / 0.3048, 1e-12);
  EXPECT_EQ(GDALGetRasterOffset(GDALGetRasterBand(file, 1), nullptr), 120) << "heights: metres";
  GDALClose(file);
}

// EPSG:8712 is in feet with heights in feet: heights in the bands are not.
TEST(GeoTiff, leavesOutHeightsOfOtherUnits)
{
  const TempDir dir;
  const Layer<float> floor = numbered({1, 0, 0, 2, 2});
  const auto systemOf = [&](const std::string& system)
  {
    writeGeoTiff(dir.path("x.tif"), {{"floor", &floor}}, {}, {{}, system, 1});
    return readGeoReference(dir.path("x.tif")).coordinateSystem;
  };
  EXPECT_EQ(systemOf("EPSG:8712"), "EPSG:3433") << "what lies in the plane";
  EXPECT_EQ(systemOf("EPSG:5698").substr(0, 8), "COMPD_CS") << "heights in metres stay";
}

TEST(GeoTiff, itemsThatAreNoLengthsAreNamed)
{
  const TempDir dir;
  const Layer<float> floor = numbered({1, 0, 0, 2, 2});
  for (const auto& [item, value] : Metadata{{"metresPerUnit", "-1"}, {"cellSize", "0"}})
  {
    writeGeoTiff(dir.path("x.tif"), {{"floor", &floor}}, {{item, value}});
    const auto message = messageOf([&] { readGeoTiffBand(dir.path("x.tif"), "floor"); });
    EXPECT_NE(message.find(item + " is " + value + ", which must be > 0"), std::string::npos)
        << message;
  }
}

TEST(GeoTiff, readsBackTheSameLayer)
{
  const TempDir dir;
  for (const double resolution : {0.05, 0.07, 0.1, 1.0 / 3, 2.0})
  {
    const GridFrame frame{resolution, -123457, 98765, 70, 45};
    Layer<float> floor = noise(frame), other(frame, kNan);
    floor.at(0, 44) = kNan;
    floor.at(69, 0) = -std::numeric_limits<float>::infinity();
    writeGeoTiff(dir.path("x.tif"), {{"other", &other}, {"floor", &floor}});
    EXPECT_TRUE(same(readGeoTiffBand(dir.path("x.tif"), "floor"), floor)) << resolution;
    EXPECT_TRUE(same(readGeoTiffBand(dir.path("x.tif"), "other"), other)) << resolution;
  }
}

TEST(GeoTiff, refusesLayersThatDoNotFit)
{
  const TempDir dir;
  const Layer<float> a(GridFrame{0.1, 0, 0, 2, 2}, 0), b(GridFrame{0.1, 1, 0, 2, 2}, 0), none;
  EXPECT_THROW(writeGeoTiff(dir.path("x"), {}), std::invalid_argument);
  EXPECT_THROW(writeGeoTiff(dir.path("x"), {{"none", &none}}), std::invalid_argument);
  const auto message = messageOf<std::invalid_argument>(
      [&] {
        writeGeoTiff(dir.path("x"), {{"a", &a}, {"b", &b}});
      });
  EXPECT_TRUE(contains(message, "'b' is on another frame than 'a'")) << message;
  EXPECT_EQ(dir.entries(), 0U);
}

TEST(GeoTiff, errorsNameTheFile)
{
  const TempDir dir;
  const Layer<float> layer(GridFrame{0.1, 0, 0, 2, 2}, 0);
  mrpt_mapconv::files::writeFile(dir.path("file"), "no TIFF");
  const auto write = messageOf([&] { writeGeoTiff(dir.path("file/x.tif"), {{"a", &layer}}); });
  EXPECT_EQ(write, "cannot write '" + dir.path("file/x.tif") + "': Not a directory");
  for (const char* name : {"file", "none"})
  {
    const auto read = messageOf([&] { readGeoTiffBand(dir.path(name), "a"); });
    EXPECT_TRUE(contains(read, "cannot read '" + dir.path(name))) << read;
    EXPECT_FALSE(contains(read, "\n")) << read;
  }
}

TEST(GeoTiff, noticesFullDiskWheneverItFills)
{
  const Layer<float> layer = noise({0.1, 0, 0, 200, 200});  // some 120 kB compressed
  const TempDir dir;
  writeGeoTiff(dir.path("x.tif"), {{"a", &layer}});
  const auto size = static_cast<int>(std::filesystem::file_size(dir.path("x.tif")));
  for (int kilobytes = 4; kilobytes < size / 1024 - 4; kilobytes += 8)
  {
    const TinyDisk disk(kilobytes);
    if (!disk.mounted()) GTEST_SKIP() << "not allowed to mount a small disk";
    const auto message = messageOf([&] { writeGeoTiff(disk.path("x.tif"), {{"a", &layer}}); });
    EXPECT_TRUE(contains(message, "cannot write '" + disk.path("x.tif"))) << message;
  }
}

TEST(GeoTiff, namesTheBandsThereAre)
{
  const TempDir dir;
  const Layer<float> layer(GridFrame{0.1, 0, 0, 2, 2}, 0);
  writeGeoTiff(dir.path("x.tif"), {{"floor", &layer}, {"slope", &layer}});
  const auto message = messageOf([&] { readGeoTiffBand(dir.path("x.tif"), "roof"); });
  EXPECT_TRUE(contains(message, "no band 'roof', only 'floor', 'slope'")) << message;
}

TEST(GeoTiff, readsForeignNoData)
{
  const TempDir dir;
  double transform[] = {-2.5, 0.5, 0, 7, 0, -0.5};
  const double noData = -9;
  writeForeign(dir.path("x.tif"), transform, &noData);
  const Layer<float> layer = readGeoTiffBand(dir.path("x.tif"), "h");
  EXPECT_EQ(layer.frame(), (GridFrame{0.5, -5, 13, 2, 1}));
  EXPECT_EQ(layer.at(0, 0), 5.0f);
  EXPECT_TRUE(std::isnan(layer.at(1, 0)));
}

TEST(GeoTiff, MetadataComeBack)
{
  const TempDir dir;
  const std::string path = dir.path("meta.tif");
  const auto layer = numbered({0.5, 0, 0, 2, 1});
  writeGeoTiff(path, {{"a", &layer}}, {{"minClearance", "1.5"}, {"note", "x = y"}});
  const Metadata metadata = readGeoTiffMetadata(path);
  EXPECT_EQ("1.5", metadata.at("minClearance"));
  EXPECT_EQ("x = y", metadata.at("note"));
  EXPECT_THROW(readGeoTiffMetadata(dir.path("none.tif")), std::runtime_error);
}

TEST(GeoTiff, refusesForeignFramesWithoutIntegerKeys)
{
  const TempDir dir;
  double between[] = {-2.4, 0.5, 0, 7, 0, -0.5}, oblong[] = {0, 0.5, 0, 7, 0, -0.4};
  double turned[] = {0, 0.5, 0.1, 7, 0, -0.5}, southUp[] = {0, 0.5, 0, 7, 0, 0.5};
  double tooFar[] = {1e12, 0.5, 0, 7, 0, -0.5};
  for (double* transform :
       {between, oblong, turned, southUp, tooFar, static_cast<double*>(nullptr)})
  {
    writeForeign(dir.path("x.tif"), transform, nullptr);
    const auto message = messageOf([&] { readGeoTiffBand(dir.path("x.tif"), "h"); });
    EXPECT_TRUE(contains(message, "cannot read '" + dir.path("x.tif"))) << message;
    std::filesystem::remove(dir.path("x.tif"));
  }
}
