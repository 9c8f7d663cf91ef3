#include <gtest/gtest.h>
#include <mrpt_mapconv/grid/CoordinateSystem.h>

#include <stdexcept>

using namespace mrpt_mapconv::grid;

TEST(CoordinateSystem, unknownOnesAreRefused)
{
  EXPECT_NO_THROW(requireCoordinateSystem(""));
  EXPECT_NO_THROW(requireCoordinateSystem("EPSG:4326"));
  EXPECT_THROW(requireCoordinateSystem("EPSG:1"), std::runtime_error);
  EXPECT_THROW(requireCoordinateSystem("nowhere"), std::runtime_error);
}

TEST(CoordinateSystem, namesOfFilesAndAddressesAreNoSystems)
{
  EXPECT_FALSE(unitsOf("/etc/passwd"));
  EXPECT_FALSE(unitsOf("http://127.0.0.1:9/x"));
}

TEST(CoordinateSystem, unitsAreThoseOfTheSystem)
{
  const auto plane = [](double horizontal, std::optional<double> vertical = {}) {
    return SystemUnits{SystemKind::Plane, horizontal, vertical};
  };
  EXPECT_EQ(unitsOf("EPSG:32633"), plane(1));
  EXPECT_EQ(unitsOf("EPSG:2992"), plane(kFoot));
  EXPECT_NEAR(unitsOf("EPSG:2227")->horizontal, kSurveyFoot, 1e-12);
  EXPECT_EQ(unitsOf("EPSG:5698"), plane(1, 1)) << "Lambert-93 with heights";
  const auto both = unitsOf("EPSG:8712");
  ASSERT_TRUE(both && both->vertical);
  EXPECT_NEAR(both->horizontal, kSurveyFoot, 1e-12);
  EXPECT_NEAR(*both->vertical, kSurveyFoot, 1e-12);
  EXPECT_FALSE(unitsOf(""));
  EXPECT_FALSE(unitsOf("EPSG:1"));
}

TEST(CoordinateSystem, degreesAndTheEarthsMiddleAreTold)
{
  EXPECT_EQ(unitsOf("EPSG:4326")->kind, SystemKind::Geographic);
  EXPECT_EQ(unitsOf("EPSG:4979")->kind, SystemKind::Geographic);
  EXPECT_EQ(unitsOf("EPSG:4978")->kind, SystemKind::Geocentric);
}

TEST(CoordinateSystem, unitsOfTextsAreTold)
{
  const std::string base =
      "GEOGCS[\"NAD83\",DATUM[\"D\",SPHEROID[\"GRS 1980\",6378137,298.257222101]],"
      "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]";
  EXPECT_EQ(unitsOf(base)->kind, SystemKind::Geographic);
  const auto plane = unitsOf(
      "PROJCS[\"x\"," + base +
      ",PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],"
      "PARAMETER[\"central_meridian\",9],PARAMETER[\"scale_factor\",1],"
      "PARAMETER[\"false_easting\",0],PARAMETER[\"false_northing\",0],UNIT[\"foot\",0.3048]]");
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->kind, SystemKind::Plane);
  EXPECT_EQ(plane->horizontal, kFoot);
}

TEST(CoordinateSystem, heightsAreMeasuredAsTheRestUnlessItIsSaid)
{
  EXPECT_EQ((SystemUnits{SystemKind::Plane, kFoot, {}}).ofHeights(), kFoot);
  EXPECT_EQ((SystemUnits{SystemKind::Plane, kFoot, 1}).ofHeights(), 1);
}

TEST(CoordinateSystem, unitsHaveNames)
{
  EXPECT_EQ(unitInWords(1), "m");
  EXPECT_EQ(unitInWords(kFoot), "feet");
  EXPECT_EQ(unitInWords(0.3048006096), "US survey feet") << "as files round it";
  EXPECT_EQ(unitInWords(0.5), "units of 0.5 m");
}
