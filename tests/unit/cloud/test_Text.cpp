#include <gtest/gtest.h>

#include "CloudBytes.h"

using namespace mrpt_mapconv::cloud;
using namespace mrpt_mapconv::testing;

namespace
{
void expectTwoPoints(const std::string& text)
{
  SCOPED_TRACE(text);
  const PointCloud cloud = readBytesAs("a.txt", text);
  EXPECT_EQ((std::vector<double>{1, -4}), cloud.x);
  EXPECT_EQ((std::vector<double>{2.5, 5}), cloud.y);
  EXPECT_EQ((std::vector<double>{3, 600}), cloud.z);
}
}  // namespace

TEST(TextCloud, BlanksTabsCommasAndSemicolonsSeparate)
{
  expectTwoPoints("1 2.5 3\n-4 5 6e2\n");
  expectTwoPoints("1\t2.5\t3\n-4\t+5\t600");
  expectTwoPoints("  1   2.5\t 3  \r\n\r\n -4 5 600\r\n");
  expectTwoPoints("1,2.5,3\n-4,5,600\n");
  expectTwoPoints("1, 2.5 , 3\n-4 ,5, 600\n");
  expectTwoPoints("1;2.5;3\n-4; 5;600\n");
  expectTwoPoints(
      "\xEF\xBB\xBF"
      "1 2.5 3\n-4 5 600\n");
  EXPECT_EQ("text, separated by semicolons", readBytesAs("a.csv", "1;2;3\n").format);
}

TEST(TextCloud, ALineOfNamesSaysWhatColumnsAre)
{
  expectTwoPoints("X Y Z\n1 2.5 3\n-4 5 600\n");
  expectTwoPoints("# x y z\n1 2.5 3\n-4 5 600\n");
  expectTwoPoints("//X Y Z\n1 2.5 3\n-4 5 600\n");
  expectTwoPoints("\"z\",\"who\",\"y\",\"x\"\n3,me,2.5,1\n600,\"you\",5,-4\n");
  expectTwoPoints("# scanned in May\n# z;x;y\n3;1;2.5\n600;-4;5\n");
  expectTwoPoints("Easting [m];Northing [m];Elevation [m]\n1;2.5;3\n-4;5;600\n");
  const PointCloud cloud = readBytesAs(
      "a.csv",
      "x,y,z,GPS_Time,Intensity,Return Number,Number Of Returns,Classification,Withheld,Red\n"
      "1,2,3,1e5,0.5,2,4,6,1,77\n");
  EXPECT_EQ(1e5, cloud.time[0]);
  EXPECT_EQ(0.5F, cloud.intensity[0]);
  EXPECT_EQ(2, cloud.returnNumber[0]);
  EXPECT_EQ(4, cloud.numberOfReturns[0]);
  EXPECT_EQ(6, cloud.classification[0]);
  EXPECT_EQ(1, cloud.withheld[0]);
  EXPECT_EQ(std::vector<std::string>{"Red"}, cloud.otherFields);
}

TEST(TextCloud, WithoutNamesTheFirstThreeColumnsAreCoordinates)
{
  const PointCloud cloud = readBytesAs("a.xyz", "# a scan\n1 2.5 3 99 red\n-4 5 600 98 -\n");
  EXPECT_EQ((std::vector<double>{3, 600}), cloud.z);
  EXPECT_TRUE(cloud.intensity.empty());
  EXPECT_EQ((std::vector<std::string>{"column 4", "column 5"}), cloud.otherFields);
}

TEST(TextCloud, NamesThatAreGivenCountMoreThanThoseOfTheFile)
{
  const PointCloud cloud = readBytesAs("a.csv", "x,y,z,time\n1,2,3,4\n", {{}, "z,time,x,y"});
  EXPECT_EQ(3, cloud.x[0]);
  EXPECT_EQ(4, cloud.y[0]);
  EXPECT_EQ(1, cloud.z[0]);
  EXPECT_EQ(2, cloud.time[0]);
  EXPECT_EQ(5, readBytesAs("a.xyz", "1 2 3 4 5 6\n", {{}, "x y _ time z"}).z[0]);
  expectRefused("a.xyz", "1 2 3\n", "columns", {{}, "x,y,z,time"});
}

TEST(TextCloud, ALineOfOneNumberSaysHowManyPointsFollow)
{
  expectTwoPoints("2\n1 2.5 3\n-4 5 600\n");
  expectRefused("a.pts", "3\n1 2.5 3\n-4 5 600\n", "says to have 3 points, but has 2");
}

TEST(TextCloud, CommentsAndEmptyLinesMayStandBetweenPoints)
{
  expectTwoPoints("1 2.5 3\n\n# half\n  // more\n-4 5 600\n\n");
}

TEST(TextCloud, PointsThatAreNoneAreCounted)
{
  const PointCloud cloud = readBytesAs("a.txt", "1 2 3\nnan nan nan\n1 inf 3\n-4 5 -inf\n");
  EXPECT_EQ(1U, cloud.size());
  EXPECT_EQ(3U, cloud.notFinite);
}

TEST(TextCloud, BrokenLinesAreNamedByNumber)
{
  expectRefused("a.txt", "# x y z\n\n1 2 3\n1 2 3x\n", "line 4: '3x' in column 3 is no number");
  expectRefused("a.txt", "1 2 3\n1 2\n", "line 2: has 2 columns where points have 3");
  expectRefused("a.txt", "1 2 3\n1 2 3 4\n", "line 2: has 4 columns where points have 3");
  expectRefused("a.csv", "1,2,3\n1,,3\n", "line 2: '' in column 2 is no number");
  expectRefused("a.csv", "1,2,3\n1 2 3\n", "line 2: has 1 column where");
  expectRefused("a.txt", "1 2\n", "line 1: has 2 columns");
  expectRefused("a.txt", "1 2 3\nx y z\n", "line 2: 'x' in column 1");
  expectRefused("a.csv", "when,what\n1,2\n",
                "line 1: is neither a point nor names columns x, y and z");
  expectRefused("a.csv", "x,y,z,class\n1,2,3,-1\n", "classification = -1 is not valid");
  expectRefused("a.txt", "1 2 1e999\n", "'1e999' in column 3");
}

TEST(TextCloud, TextsWithoutPointsAreNamed)
{
  expectRefused("a.txt", "\n", "holds no point");
  expectRefused("a.csv", "x,y,z\n", "holds no point");
  expectRefused("a.txt", "# nothing\n", "holds no point");
}

TEST(TextCloud, WhatHasNoLinesIsNoText)
{
  expectRefused("a.txt", std::string(3 << 20, '1'), "line 1 is longer than 1 MB");
}

TEST(TextCloud, ACommaIsNoDecimalPoint) { expectRefused("a.csv", "1,5;2,5;3,0\n", "line 1: "); }
