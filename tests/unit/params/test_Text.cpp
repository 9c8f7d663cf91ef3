#include <gtest/gtest.h>
#include <mrpt_mapconv/params/Text.h>

using namespace mrpt_mapconv::params;

TEST(Text, CountedIsSingularForOneOnly)
{
  EXPECT_EQ("0 scans", counted(0, "scan"));
  EXPECT_EQ("1 scan", counted(1, "scan"));
  EXPECT_EQ("2 scans", counted(2, "scan"));
}
