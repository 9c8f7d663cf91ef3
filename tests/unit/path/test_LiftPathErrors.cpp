// What liftPath() refuses, and in which words.
#include <gtest/gtest.h>
#include <mrpt_mapconv/path/LiftPath.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "FlatLayers.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::path;
using test::flatLayers;
using test::ground;
using test::sphere;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string errorOf(const std::function<void()>& task)
{
  try
  {
    task();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "no error";
}

std::string errorOf(const LiftParams& params)
{
  return errorOf([&] { liftPath({}, flatLayers(), {}, params); });
}

TEST(LiftParams, DefaultsFitTheConversionsDefaults) { EXPECT_NO_THROW(LiftParams{}.check(1.0)); }

TEST(LiftParams, SafetyRadius)
{
  for (const double radius : {0.0, -0.3, 0.50001, kNaN, kInfinity})
  {
    LiftParams params = sphere(1);
    params.safetyRadius = radius;
    EXPECT_NE(errorOf(params).find("safetyRadius = "), std::string::npos) << radius;
    params.robot = freespace::Robot::Ground;
    EXPECT_EQ(errorOf(params), "no error") << "a ground robot has no sphere";
  }
  LiftParams params = sphere(1);
  params.safetyRadius = 0.6;
  EXPECT_EQ(errorOf(params),
            "safetyRadius = 0.6 is not valid: it must be above 0 m and at most minClearance/2 = "
            "0.5 m");
  params.safetyRadius = 0.5;
  EXPECT_EQ(errorOf(params), "no error");
}

TEST(LiftParams, LookaheadAndOffset)
{
  for (const double bad : {-0.1, kNaN, kInfinity})
  {
    EXPECT_NE(errorOf(sphere(1, bad)).find("lookahead = "), std::string::npos) << bad;
    EXPECT_NE(errorOf(ground(bad, 0)).find("heightOffset = "), std::string::npos) << bad;
  }
  EXPECT_EQ(errorOf(ground(0, 0)), "no error");
}

TEST(LiftPath, RefusesBadConversionParameters)
{
  auto conversion = freespace::ConversionParams::paper();
  conversion.slopeWindow = 0;
  const std::string error = errorOf([&] { liftPath({}, flatLayers(), conversion, ground(0, 0)); });
  EXPECT_NE(error.find("slopeWindow = 0"), std::string::npos) << error;
}

TEST(LiftPath, RefusesPointsThatAreNotFinite)
{
  EXPECT_EQ(errorOf(
                [] {
                  liftPath({{1, 1}, {1, kNaN}}, flatLayers(), {}, sphere(1));
                }),
            "path point 1 = (1, nan) is not valid: both coordinates must be finite");
  EXPECT_EQ(errorOf(
                [] {
                  liftPath({{-kInfinity, 1}}, flatLayers(), {}, sphere(1));
                }),
            "path point 0 = (-inf, 1) is not valid: both coordinates must be finite");
}

TEST(LiftPath, RefusesPathsWithoutEnd)
{
  for (const double far : {1e8, 1e300, 1e308})
  {
    const std::string error = errorOf(
        [&] {
          liftPath({{-far, 1}, {far, 1}}, flatLayers(), {}, sphere(1));
        });
    EXPECT_NE(error.find("path point 1"), std::string::npos) << error;
  }
}

TEST(LiftPath, RefusesLayersThatDoNotFit)
{
  EXPECT_NE(errorOf([] { liftPath({}, {}, {}, sphere(1)); }).find("empty"), std::string::npos);
  freespace::Layers layers = flatLayers();
  layers.ceiling = layers.ceiling.onFrame({0.25, 0, 0, 20, 11}, 0);
  EXPECT_NE(errorOf([&] { liftPath({}, layers, {}, sphere(1)); }).find("one frame"),
            std::string::npos);
}

}  // namespace
