#include <gtest/gtest.h>
#include <mrpt_mapconv/params/Text.h>

#include <cmath>
#include <limits>

namespace
{
using namespace mrpt_mapconv::params;

TEST(Text, CountedIsSingularForOneOnly)
{
  EXPECT_EQ("0 scans", counted(0, "scan"));
  EXPECT_EQ("1 scan", counted(1, "scan"));
  EXPECT_EQ("2 scans", counted(2, "scan"));
}

TEST(Text, RoundedNumbersHaveThreeDecimalsAtMost)
{
  EXPECT_EQ(roundedText(std::sqrt(2.0)), "1.414");
  EXPECT_EQ(roundedText(-0.447214), "-0.447");
  EXPECT_EQ(roundedText(0.30000000000000004), "0.3");
  EXPECT_EQ(roundedText(1200), "1200");
  EXPECT_EQ(roundedText(-0.0001), "0");
  EXPECT_EQ(roundedText(123456.7891), "123456.789");
}

TEST(Text, PlacesHaveMillimetresAtAnySize)
{
  EXPECT_EQ(placeText(5411929.05), "5411929.05");
  EXPECT_EQ(placeText(1.6e9), "1600000000");
  EXPECT_EQ(placeText(-0.0001), "0");
  EXPECT_EQ(placeText(0.12345), "0.123");
  EXPECT_EQ(placeText(std::numeric_limits<double>::infinity()), "inf");
}

TEST(Text, RoundedNumbersThatAreLargeOrNone)
{
  EXPECT_EQ(roundedText(1.27279e8), "1.273e+08");
  EXPECT_EQ(roundedText(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(roundedText(std::numeric_limits<double>::max()), "1.798e+308");
}

}  // namespace
