#include <gtest/gtest.h>
#include <mrpt_mapconv/observation/TrajectoryFile.h>

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

#include "support/TempDir.h"

using namespace mrpt_mapconv;
using observation::PoseTrack;
using observation::timeStampOf;

namespace
{
PoseTrack read(const std::string& text)
{
  const mrpt_mapconv::testing::TempDir dir;
  std::ofstream(dir.path("way.txt")) << text;
  return observation::readTrajectoryFile(dir.path("way.txt"));
}

std::string refusal(const std::string& text)
{
  try
  {
    read(text);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

mrpt::poses::CPose3D at(const PoseTrack& track, double seconds)
{
  const auto pose = track.at(timeStampOf(seconds));
  EXPECT_TRUE(pose) << seconds;
  return pose.value_or(mrpt::poses::CPose3D());
}
}  // namespace

TEST(TrajectoryFile, SevenColumnsAreAsTheSimulatorWritesThem)
{
  const auto track = read("t,x,y,z,yaw,pitch,roll\n0,1,2,3,0.5,0,0\n1,3,2,3,0.5,0.1,0\n");
  EXPECT_EQ(track.size(), 2u);
  const auto middle = at(track, 0.5);
  EXPECT_NEAR(middle.x(), 2, 1e-9);
  EXPECT_NEAR(middle.yaw(), 0.5, 1e-9);
  EXPECT_NEAR(middle.pitch(), 0.05, 1e-9);
}

TEST(TrajectoryFile, EightColumnsAreThoseOfTum)
{
  const double half = std::sqrt(0.5);  // a quarter turn about z
  const auto track =
      read("# timestamp tx ty tz qx qy qz qw\n1305031102.5 448258.25 5411929.5 7 0 0 " +
           std::to_string(half) + " " + std::to_string(half) + "\n");
  const auto pose = at(track, 1305031102.5);
  EXPECT_NEAR(pose.x(), 448258.25, 1e-9);
  EXPECT_NEAR(pose.y(), 5411929.5, 1e-9);
  EXPECT_NEAR(pose.yaw(), M_PI / 2, 1e-5);
}

TEST(TrajectoryFile, TwentyEightColumnsHaveTheCovariance)
{
  std::string line = "5;0;0;0;0;0;0";
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column)
      line += ";" + std::to_string(row == column ? row + 100 : 10 * row + column);
  const auto track = read(line + "\n");
  const auto covariance = track.covarianceAt(timeStampOf(5));
  ASSERT_TRUE(covariance);  // z, roll, pitch: rows 2, 5, 4
  EXPECT_EQ((*covariance)(0, 0), 102);
  EXPECT_EQ((*covariance)(1, 1), 105);
  EXPECT_EQ((*covariance)(2, 2), 104);
  EXPECT_EQ((*covariance)(0, 1), 25);
  EXPECT_EQ((*covariance)(0, 2), 24);
  EXPECT_EQ((*covariance)(1, 2), 45);
}

TEST(TrajectoryFile, LengthsOfOtherUnitsBecomeMetres)
{
  const mrpt_mapconv::testing::TempDir dir;
  std::string line = "1 10 20 30 0.1 0.2 0.3";
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column) line += row == column ? " 4" : " 1";
  std::ofstream(dir.path("way.txt")) << line << "\n";
  const auto track = observation::readTrajectoryFile(dir.path("way.txt"), {0.5, 0.25});
  const auto pose = at(track, 1);
  EXPECT_EQ(pose.x(), 5);
  EXPECT_EQ(pose.y(), 10);
  EXPECT_EQ(pose.z(), 7.5);
  EXPECT_NEAR(pose.yaw(), 0.1, 1e-12);
  const auto covariance = track.covarianceAt(timeStampOf(1));
  ASSERT_TRUE(covariance);
  EXPECT_EQ((*covariance)(0, 0), 4 * 0.25 * 0.25) << "of z";
  EXPECT_EQ((*covariance)(0, 1), 0.25) << "of z and an angle";
  EXPECT_EQ((*covariance)(1, 1), 4);
}

TEST(TrajectoryFile, LinesMayComeInAnyOrder)
{
  const auto track = read("1 1 0 0 0 0 0\n0 0 0 0 0 0 0\n0.5 8 0 0 0 0 0\n");
  EXPECT_NEAR(at(track, 0.25).x(), 4, 1e-9);
}

TEST(TrajectoryFile, ABrokenLineIsNamedByItsNumber)
{
  const std::string good = "0 0 0 0 0 0 0\n";
  for (const auto& [text, what] : {std::pair<std::string, std::string>{good + "1 2 3\n", "line 2"},
                                   {good + "\n1 2 3 4 5 6 nan\n", "line 3"},
                                   {good + "1 2 3 4 5 6 x\n", "no finite number"},
                                   {good + "1 2 3 4 5 6 7 8\n", "8 columns"},
                                   {"1 2 3 4 5 6 7 8\n", "quaternion"},
                                   {"1 2 3 4 5 6 7 8 9\n", "9 columns"},
                                   {"", "is empty"},
                                   {"t x y\n", "no pose"}})
  {
    const auto message = refusal(text);
    EXPECT_NE(message.find(what), std::string::npos) << message;
    EXPECT_NE(message.find("way.txt"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(TrajectoryFile, QuaternionsAreNormalizedUpToAHundredth)
{
  for (const double length : {1.0005, 0.995, 1.0095})
  {
    const std::string part = std::to_string(length * std::sqrt(0.5));
    EXPECT_NEAR(at(read("1 2 3 4 0 0 " + part + " " + part + "\n"), 1).yaw(), M_PI / 2, 1e-5);
  }
  EXPECT_NE(refusal("0 0 0 0 0 0 0 1\n1 2 3 4 0 0 0 0.98\n").find("way.txt, line 2"),
            std::string::npos);
}

TEST(TrajectoryFile, OneTimeHasOnePose)
{
  const std::string line = "1 2 3 4 0.1 0 0\n";
  EXPECT_EQ(read(line + line).size(), 1u);
  for (const char* other : {"1 2 3 5 0.1 0 0\n", "1.00000000001 2 3 4 0.2 0 0\n"})
  {
    const auto message = refusal(line + "0 0 0 0 0 0 0\n" + other);
    EXPECT_NE(message.find("way.txt, line 3: "), std::string::npos) << message;
    EXPECT_NE(message.find("another pose"), std::string::npos) << message;
  }
}

TEST(TrajectoryFile, PositionsLieOnEarth)
{
  for (const char* place : {"1e300 0 0", "0 -2e9 0", "0 0 1e10"})
  {
    const auto message = refusal("0 0 0 0 0 0 0\n1 " + std::string(place) + " 0 0 0\n");
    EXPECT_NE(message.find("way.txt, line 2: "), std::string::npos) << message;
    EXPECT_NE(message.find("1e9 m from 0"), std::string::npos) << message;
  }
}

TEST(TrajectoryFile, ACovarianceThatIsNoneIsNamedByItsLine)
{
  const auto line = [](int at, const std::string& value)
  {
    std::string text = "1 0 0 0 0 0 0";
    int next = 0;
    for (int row = 0; row < 6; ++row)
      for (int column = row; column < 6; ++column, ++next)
        text += " " + (next == at ? value : row == column ? "0.01" : "0");
    return text + "\n";
  };
  constexpr int kVarianceOfX = 0, kXAndY = 1, kVarianceOfRoll = 20;
  for (const auto& text : {line(kVarianceOfX, "-0.01"), line(kVarianceOfRoll, "-1e-9"),
                           line(kXAndY, "0.011"), line(kXAndY, "-0.02")})
  {
    const auto message = refusal(text);
    EXPECT_NE(message.find("way.txt, line 1: "), std::string::npos) << message;
    EXPECT_NE(message.find("has a covariance that is none"), std::string::npos) << message;
  }
  EXPECT_EQ(refusal(line(kXAndY, "0.010001")), "") << "rounded";
  EXPECT_EQ(refusal(line(kVarianceOfX, "0")), "");
}
