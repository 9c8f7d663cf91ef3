#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>

#include "CloudBytes.h"
#include "LasBytes.h"

using namespace mrpt_mapconv::cloud;
using namespace mrpt_mapconv::testing;

namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/** The points of the file, with nothing taken off. */
PointCloud readLas(const LasBytes& las)
{
  return readBytesAs("a.las", las.bytes(), {mrpt::math::TPoint3D(0, 0, 0), ""});
}

LasBytes onePoint(int format = 0, int minor = 2)
{
  LasBytes las;
  las.format = format;
  las.minor = minor;
  las.add(100, 200, 300);
  return las;
}

void expectRefusedLas(const LasBytes& las, const std::string& words)
{
  expectRefused("a.las", las.bytes(), words);
}

constexpr int kFormats = 11;
bool isOld(int format) { return format < 6; }
}  // namespace

TEST(LasReader, PointFormats0To10HaveTheirFieldsInTheirPlaces)
{
  for (int format = 0; format < kFormats; ++format)
  {
    const std::size_t timeAt = format == 0 || format == 2 ? 0 : isOld(format) ? 20 : 22;
    LasBytes las = onePoint(format, isOld(format) ? 2 : 4);
    las.add(-100, 0, 5);
    las.set(12, std::uint16_t(65535));
    las.set(14, static_cast<std::uint8_t>(isOld(format) ? 2 | 5 << 3 : 11 | 14 << 4));
    las.set(isOld(format) ? 15 : 16, static_cast<std::uint8_t>(isOld(format) ? 17 : 200));
    if (timeAt > 0) las.set(timeAt, 1234.5);
    const PointCloud cloud = readLas(las);
    ASSERT_EQ(2U, cloud.size()) << format;
    EXPECT_EQ((std::vector<double>{1, -1}), cloud.x) << format;
    EXPECT_EQ((std::vector<double>{2, 0}), cloud.y) << format;
    EXPECT_EQ((std::vector<double>{3, 0.05}), cloud.z) << format;
    EXPECT_EQ((std::vector<float>{0, 65535}), cloud.intensity) << format;
    EXPECT_EQ(isOld(format) ? 2 : 11, cloud.returnNumber[1]) << format;
    EXPECT_EQ(isOld(format) ? 5 : 14, cloud.numberOfReturns[1]) << format;
    EXPECT_EQ(isOld(format) ? 17 : 200, cloud.classification[1]) << format;
    EXPECT_EQ(timeAt > 0 ? (std::vector<double>{0, 1234.5}) : std::vector<double>(), cloud.time);
    EXPECT_EQ((std::vector<std::uint8_t>{0, 0}), cloud.withheld) << format;
  }
}

TEST(LasReader, WithheldIsABitOfItsOwnInOldAndNewFormats)
{
  for (int format = 0; format < kFormats; ++format)
  {
    LasBytes las = onePoint(format, isOld(format) ? 2 : 4);
    // all other flags of the byte are set on the second point
    las.set(15, static_cast<std::uint8_t>(isOld(format) ? 0x80 | 2 : 0x04));
    las.add(0, 0, 0);
    las.set(15, static_cast<std::uint8_t>(isOld(format) ? 0x60 | 2 : 0xFB));
    const PointCloud cloud = readLas(las);
    EXPECT_EQ((std::vector<std::uint8_t>{1, 0}), cloud.withheld) << format;
    EXPECT_EQ(isOld(format) ? 2 : 0, cloud.classification[1]) << format;
  }
}

TEST(LasReader, Versions0To4AreReadAndNamed)
{
  for (int minor = 0; minor <= 4; ++minor)
  {
    const PointCloud cloud = readLas(onePoint(1, minor));
    EXPECT_EQ(1U, cloud.size());
    EXPECT_EQ("LAS 1." + std::to_string(minor) + ", point format 1", cloud.format);
  }
}

TEST(LasReader, BytesThatProgramsAddToPointsAreReadOver)
{
  LasBytes las;
  las.pointSize = 31;
  las.add(1, 2, 3);
  las.add(4, 5, 6);
  EXPECT_EQ((std::vector<double>{0.01, 0.04}), readLas(las).x);
}

TEST(LasReader, ScaleAndOffsetAreOfEachAxis)
{
  LasBytes las = onePoint();
  las.scale = {0.5, 0.25, 2};
  las.offset = {1000, -10, 0.125};
  const PointCloud cloud = readLas(las);
  EXPECT_EQ(1050, cloud.x[0]);
  EXPECT_EQ(40, cloud.y[0]);
  EXPECT_EQ(600.125, cloud.z[0]);
}

TEST(LasReader, FarCoordinatesKeepTheirMillimetres)
{
  LasBytes las;
  las.scale = {0.001, 0.001, 0.001};
  las.offset = {600000, 5000000, 0};
  las.add(1234, 567, 400001);
  const PointCloud cloud = readBytesAs("a.las", las.bytes());
  EXPECT_EQ(mrpt::math::TPoint3D(600001, 5000000, 0), cloud.origin);
  EXPECT_NEAR(0.234, cloud.x[0], 1e-9);
  EXPECT_NEAR(0.567, cloud.y[0], 1e-9);
  EXPECT_NEAR(400.001, cloud.z[0], 1e-9);
}

TEST(LasReader, TheCoordinateSystemIsThatOfGeoTiffKeysOrWkt)
{
  LasBytes las = onePoint();
  las.record("elsewhere", 34735, geoKeys(3072, 4));
  las.record("LASF_Projection", 34735, geoKeys(3072, 32632));
  EXPECT_EQ("EPSG:32632", readLas(las).coordinateSystem);
  las.record("LASF_Projection", 2112, std::string("PROJCS[\"a\"]\0\0", 13));
  EXPECT_EQ("EPSG:32632", readLas(las).coordinateSystem);
  las.encoding = 0x10;
  EXPECT_EQ("PROJCS[\"a\"]", readLas(las).coordinateSystem);

  LasBytes late = onePoint(6, 4);
  late.lateRecord("LASF_Projection", 2112, "GEOGCS[]");
  EXPECT_EQ("GEOGCS[]", readLas(late).coordinateSystem);
}

TEST(LasReader, KeysWithoutACodeNameNoSystem)
{
  LasBytes las = onePoint();
  EXPECT_EQ("", readLas(las).coordinateSystem);
  las.record("LASF_Projection", 34735, geoKeys(3072, 32767));  // defined by its user
  EXPECT_EQ("", readLas(las).coordinateSystem);
  LasBytes degrees = onePoint();
  degrees.record("LASF_Projection", 34735, geoKeys({{1024, 2}, {2048, 4326}}));
  EXPECT_EQ("EPSG:4326", readLas(degrees).coordinateSystem);
  LasBytes own = onePoint();  // a projection of its user's, on top of that system
  own.record("LASF_Projection", 34735, geoKeys({{2048, 4269}, {1024, 1}, {3072, 32767}}));
  EXPECT_EQ("", readLas(own).coordinateSystem);
  LasBytes cut = onePoint();
  cut.record("LASF_Projection", 34735, geoKeys(3072, 32632).substr(0, 23));
  EXPECT_EQ("", readLas(cut).coordinateSystem);
}

TEST(LasReader, TruncatedFilesSayHowManyPointsTheyHave)
{
  LasBytes las = onePoint();
  las.add(1, 1, 1);
  const std::string bytes = las.bytes();
  expectRefused("a.las", bytes.substr(0, bytes.size() - 1),
                "promises 2 points, of which the file has 1");
  expectRefused("a.las", bytes.substr(0, 227), "of which the file has 0");
  expectRefused("a.las", bytes.substr(0, 226), "cut off within the header");
  expectRefused("a.las", bytes.substr(0, 5), "cut off within the header");
  las.record("x", 1, "payload");
  expectRefused("a.las", las.bytes().substr(0, 260),
                "its record 1 of 1 (of variable length) is cut off");
  LasBytes late = onePoint(6, 4);
  late.lateRecord("x", 1, "payload");
  const std::string whole = late.bytes();
  expectRefused("a.las", whole.substr(0, whole.size() - 1), "its record 1 of 1");
}

TEST(LasReader, HeadersThatLieAreRefusedAndNothingIsAllocatedForThem)
{
  LasBytes las = onePoint(6, 4);
  las.count = std::numeric_limits<std::uint64_t>::max();
  expectRefusedLas(las, "promises 18446744073709551615 points, of which the file has 1");
  las = onePoint();
  las.recordCount = 4000000000U;
  expectRefusedLas(las, "its record 1 of 4000000000");
  std::string bytes = onePoint().bytes();
  putAt(bytes, 96, std::uint32_t(100));
  expectRefused("a.las", bytes, "begin at byte 100, within the header");
  putAt(bytes, 96, std::uint32_t(4000000000U));
  expectRefused("a.las", bytes, "is truncated");
  putAt(bytes, 94, std::uint16_t(100));
  expectRefused("a.las", bytes, "its header says to have 100 bytes");
  LasBytes late = onePoint(6, 4);
  late.lateCount = 1;
  std::string misplaced = late.bytes();
  putAt(misplaced, 235, std::uint64_t(10));
  expectRefused("a.las", misplaced, "its record 1 of 1");
}

TEST(LasReader, ScalesAndOffsetsThatMakeNoMetresAreRefused)
{
  for (const double scale : {0.0, -0.01, kNan, std::numeric_limits<double>::infinity(), 1e30})
  {
    LasBytes las = onePoint();
    las.scale[1] = scale;
    expectRefusedLas(las, "scale of y = ");
  }
  for (const double offset : {kNan, -std::numeric_limits<double>::infinity(), 1e300})
  {
    LasBytes las = onePoint();
    las.offset[2] = offset;
    expectRefusedLas(las, "offset of z = ");
  }
}

TEST(LasReader, UnknownVersionsAndFormatsAndSmallPointsAreRefused)
{
  std::string bytes = onePoint().bytes();
  putAt(bytes, 104, std::uint8_t(11));
  expectRefused("a.las", bytes, "unknown format 11; LAS has 0 to 10");
  bytes = onePoint().bytes();
  putAt(bytes, 25, std::uint8_t(5));
  expectRefused("a.las", bytes, "is LAS 1.5");
  LasBytes small;
  small.format = 1;
  small.pointSize = 27;
  small.add(1, 2, 3);
  expectRefusedLas(small, "27 bytes each; those of format 1 have 28");
  LasBytes empty;
  expectRefusedLas(empty, "holds no point");
}

TEST(LasReader, PackedPointsAreRefusedWithWhatUnpacksThem)
{
  std::string bytes = onePoint(1).bytes();
  putAt(bytes, 104, std::uint8_t(0x81));
  expectRefused("a.laz", bytes, "pdal translate");
  expectRefused("a.las", bytes, "laspy[lazrs]");
  EXPECT_EQ(1U, readBytesAs("a.laz", onePoint().bytes()).size());  // not packed, whatever its name
}

// Values by a few lines of Python's struct, from the same bytes.
TEST(LasReader, ReadsARealFile)
{
  const std::string file = MRPT_MAPCONV_SHARED_DIR "/real/autzen-thin.las";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const PointCloud cloud = readCloudFile(file);
  ASSERT_EQ(10653U, cloud.size());
  EXPECT_EQ("LAS 1.2, point format 3", cloud.format);
  EXPECT_EQ("", cloud.coordinateSystem);
  EXPECT_EQ(mrpt::math::TPoint3D(637148, 849062, 0), cloud.origin);
  EXPECT_NEAR(637148.03, cloud.origin.x + cloud.x[0], 1e-6);
  EXPECT_NEAR(853186.42, cloud.origin.y + cloud.y[10652], 1e-6);
  EXPECT_NEAR(424.48, cloud.origin.z + cloud.z[10652], 1e-6);
  EXPECT_NEAR(6789095185.86, std::accumulate(cloud.x.begin(), cloud.x.end(), 10653 * 637148.0),
              1e-3);
  EXPECT_EQ(819976, std::accumulate(cloud.intensity.begin(), cloud.intensity.end(), 0.0));
  EXPECT_EQ(245379.93945136934, cloud.time[0]);
  EXPECT_EQ(249773.49235105232, cloud.time[10652]);
  EXPECT_EQ(7934, std::count(cloud.classification.begin(), cloud.classification.end(), 1));
  EXPECT_EQ(2719, std::count(cloud.classification.begin(), cloud.classification.end(), 2));
  EXPECT_EQ(941 + 271 + 32, std::count(cloud.returnNumber.begin(), cloud.returnNumber.end(), 2));
  EXPECT_EQ(42 + 39 + 32 + 30,
            std::count(cloud.numberOfReturns.begin(), cloud.numberOfReturns.end(), 4));
  EXPECT_EQ(0, std::count(cloud.withheld.begin(), cloud.withheld.end(), 1));
}
