#include <gtest/gtest.h>
#include <mrpt_mapconv/scan/ProfileSummary.h>

using namespace mrpt_mapconv::scan;

TEST(ProfileSummary, SaysTheModelAndTheSlices)
{
  ProfileParams params;
  params.structureMinZ = 2.3;
  params.structureMaxZ = 2.6;
  EXPECT_EQ(summaryOf(params), "wholeShape, objects from 0.05 to 1.5 m, walls from 2.3 to 2.6 m");
  params.model = Model::ClosestPoint;
  params.reflectionFilter = false;
  EXPECT_EQ(summaryOf(params), "closestPoint, objects from 0.05 to 1.5 m, no reflection filter");
}

TEST(ProfileSummary, SaysThatTheWallsAreNotGiven)
{
  EXPECT_EQ(summaryOf({}), "wholeShape, objects from 0.05 to 1.5 m, no structure slice given");
}

TEST(ProfileSummary, SaysWhichSlicesOverlapAndWhatIsRight)
{
  ProfileParams params;
  params.structureMinZ = 1;
  params.structureMaxZ = 2;
  const std::string text = overlapText(params);
  for (const char* part : {"1 to 2 m", "0.05 to 1.5 m", "structureMinZ", "objectMaxZ"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}
