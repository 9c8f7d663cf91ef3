#include <gtest/gtest.h>
#include <mrpt_mapconv/cloud/CloudFields.h>

#include <cmath>

#include "CloudBytes.h"
#include "LasBytes.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::cloud;
using namespace mrpt_mapconv::testing;
using grid::kFoot;
using grid::kSurveyFoot;
using grid::SystemKind;
using grid::SystemUnits;

namespace
{
/** A point at (636001.76, 848935.2, 411.46), of a file whose projection has these keys. */
LasBytes surveyPoint(const std::vector<std::pair<std::uint16_t, std::uint16_t>>& keys)
{
  LasBytes las;
  las.add(63600176, 84893520, 41146);
  if (!keys.empty()) las.record("LASF_Projection", 34735, geoKeys(keys));
  return las;
}

PointCloud readLas(const LasBytes& las, const CloudReading& reading = {})
{
  return readBytesAs("a.las", las.bytes(), reading);
}

/** Expects metres of these units, and the file's own values from rangeOf(). */
void expectUnits(const PointCloud& cloud, double unit, double heightUnit)
{
  EXPECT_NEAR(cloud.unit, unit, 1e-12);
  EXPECT_NEAR(cloud.heightUnit, heightUnit, 1e-12);
  EXPECT_NEAR(cloud.x[0] + cloud.origin.x, 636001.76 * unit, 1e-8);
  EXPECT_NEAR(cloud.y[0] + cloud.origin.y, 848935.2 * unit, 1e-8);
  EXPECT_NEAR(cloud.z[0] + cloud.origin.z, 411.46 * heightUnit, 1e-8);
  EXPECT_EQ(cloud.origin.x, std::floor(cloud.origin.x)) << "whole metres";
  EXPECT_NEAR(rangeOf(cloud, Field::X)->min, 636001.76, 1e-9);
  EXPECT_NEAR(rangeOf(cloud, Field::Z)->max, 411.46, 1e-9);
}
}  // namespace

TEST(CloudUnits, withoutASystemCoordinatesAreMetres)
{
  const auto cloud = readLas(surveyPoint({}));
  expectUnits(cloud, 1, 1);
  EXPECT_FALSE(cloud.namedUnits);
}

TEST(CloudUnits, keysOfUnitsCountAlsoOfAProjectionWithoutANumber)
{
  const auto feet = readLas(surveyPoint({{1024, 1}, {3072, 32767}, {3076, 9002}}));
  expectUnits(feet, kFoot, kFoot);
  EXPECT_EQ(feet.namedUnits, (SystemUnits{SystemKind::Plane, kFoot, {}}));
  expectUnits(readLas(surveyPoint({{1024, 1}, {3076, 9003}})), kSurveyFoot, kSurveyFoot);
  expectUnits(readLas(surveyPoint({{1024, 1}, {3076, 9003}, {4099, 9001}})), kSurveyFoot, 1);
  expectUnits(readLas(surveyPoint({{1024, 1}, {3076, 9001}, {4099, 9002}})), 1, kFoot);
  expectUnits(readLas(surveyPoint({{1024, 1}, {3076, 9036}})), 1, 1);
}

TEST(CloudUnits, aSystemWithANumberHasItsUnits)
{
  expectUnits(readLas(surveyPoint({{1024, 1}, {3072, 2992}})), kFoot, kFoot);
  expectUnits(readLas(surveyPoint({{1024, 1}, {3072, 2227}})), kSurveyFoot, kSurveyFoot);
  expectUnits(readLas(surveyPoint({{1024, 1}, {3072, 2992}, {4099, 9001}})), kFoot, 1);
  expectUnits(readLas(surveyPoint({{1024, 1}, {3072, 32633}})), 1, 1);
}

TEST(CloudUnits, aTextHasThemBeforeTheKeys)
{
  auto las = surveyPoint({{1024, 1}, {3072, 32633}});
  las.encoding = 0x10;
  las.record("LASF_Projection", 2112,
             "PROJCS[\"x\",GEOGCS[\"g\",DATUM[\"d\",SPHEROID[\"s\",6378137,298.25]],"
             "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],"
             "PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],"
             "PARAMETER[\"central_meridian\",9],PARAMETER[\"scale_factor\",1],"
             "PARAMETER[\"false_easting\",0],PARAMETER[\"false_northing\",0],"
             "UNIT[\"US survey foot\",0.304800609601219]]");
  expectUnits(readLas(las), kSurveyFoot, kSurveyFoot);
  EXPECT_EQ(readLas(las).namedUnits->kind, SystemKind::Plane);
}

TEST(CloudUnits, degreesStayDegrees)
{
  LasBytes las;
  las.scale = {1e-7, 1e-7, 0.01};
  las.add(90000000, 480000000, 41146);
  las.record("LASF_Projection", 34735, geoKeys({{1024, 2}, {2048, 4326}}));
  const auto cloud = readLas(las);
  EXPECT_EQ(cloud.namedUnits->kind, SystemKind::Geographic);
  EXPECT_NEAR(cloud.x[0], 9, 1e-12);
  EXPECT_EQ(cloud.unit, 1);
  LasBytes earth = surveyPoint({{1024, 3}});
  EXPECT_EQ(readLas(earth).namedUnits->kind, SystemKind::Geocentric);
}

TEST(CloudUnits, whoReadsKnowsBetter)
{
  CloudReading reading;
  reading.units = SystemUnits{SystemKind::Plane, kFoot, 1};
  expectUnits(readLas(surveyPoint({{1024, 1}, {3072, 2227}}), reading), kFoot, 1);
  const auto text = readBytesAs("a.xyz", "10 20 30\n", reading);
  EXPECT_NEAR(text.x[0], 3.048, 1e-12);
  EXPECT_EQ(text.z[0], 30);
}

TEST(CloudUnits, anOriginIsInTheUnitsOfTheFile)
{
  CloudReading reading;
  reading.origin = {636000, 848000, 400};
  const auto cloud = readLas(surveyPoint({{1024, 1}, {3076, 9002}, {4099, 9001}}), reading);
  EXPECT_NEAR(cloud.x[0], 1.76 * kFoot, 1e-8);
  EXPECT_NEAR(cloud.y[0], 935.2 * kFoot, 1e-8);
  EXPECT_NEAR(cloud.z[0], 11.46, 1e-8);
}

TEST(CloudUnits, cloudsAreWrittenAsTheyWereRead)
{
  const auto cloud = readLas(surveyPoint({{1024, 1}, {3072, 2227}, {4099, 9001}}));
  const TempDir dir;
  for (const std::string name : {"a.las", "a.ply", "a.pcd", "a.csv"})
  {
    writeCloudFile(dir.path(name), cloud);
    CloudReading metres;
    metres.units = SystemUnits();
    const auto back = readCloudFile(dir.path(name), metres);
    EXPECT_NEAR(back.x[0] + back.origin.x, 636001.76, 1e-9) << name;
    EXPECT_NEAR(back.y[0] + back.origin.y, 848935.2, 1e-9) << name;
    EXPECT_NEAR(back.z[0] + back.origin.z, 411.46, 1e-9) << name;
  }
  EXPECT_TRUE(contains(readBytes(dir.path("a.csv")), "\n636001.76,848935.2,"))
      << "without the noise of a product and a quotient";
}
