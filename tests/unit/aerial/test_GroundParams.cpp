#include <gtest/gtest.h>
#include <mrpt_mapconv/aerial/GroundParams.h>

#include <stdexcept>
#include <string>

#include "support/ThrownMessage.h"

using namespace mrpt_mapconv;
using aerial::GroundParams;

namespace
{
/** Sets one parameter and expects a complaint that names it. */
template <class Change>
void expectRefused(const char* name, const Change& change)
{
  GroundParams params;
  change(params);
  const std::string message = test::thrownMessage<std::invalid_argument>([&] { params.check(); });
  EXPECT_NE(message.find(name), std::string::npos) << message;
}
}  // namespace

TEST(GroundParams, DefaultsAreThoseOfThePublications)
{
  const GroundParams p;
  EXPECT_NO_THROW(p.check());
  EXPECT_EQ(p.groundFilter, aerial::GroundFilter::Csf);
  EXPECT_EQ(p.rigidness, 3);
  EXPECT_EQ(p.heightThreshold, 0.2);
  EXPECT_EQ(p.clothResolution, 0.5);
  EXPECT_EQ(p.timeStep, 0.65);
  EXPECT_EQ(p.gravity, 0.2);
  EXPECT_EQ(p.damping, 0.01);
  EXPECT_EQ(p.maxIterations, 500);
  EXPECT_EQ(p.restMove, 0.005);
  EXPECT_EQ(p.cellSize, 0.25);
  EXPECT_EQ(p.smrfCell, 1);
  EXPECT_EQ(p.smrfSlope, 0.15);
  EXPECT_EQ(p.smrfWindow, 18);
  EXPECT_EQ(p.smrfThreshold, 0.5);
  EXPECT_EQ(p.smrfScale, 1.25);
}

TEST(GroundParams, WrongValuesAreRefusedByName)
{
  expectRefused("cellSize", [](GroundParams& p) { p.cellSize = 0; });
  expectRefused("lowPointRadius", [](GroundParams& p) { p.lowPointRadius = -1; });
  expectRefused("lowPointDepth", [](GroundParams& p) { p.lowPointDepth = -1; });
  expectRefused("lowPointShare", [](GroundParams& p) { p.lowPointShare = 1.5; });
  expectRefused("clothResolution", [](GroundParams& p) { p.clothResolution = 0; });
  expectRefused("rigidness", [](GroundParams& p) { p.rigidness = 0; });
  expectRefused("heightThreshold", [](GroundParams& p) { p.heightThreshold = -0.1; });
  expectRefused("timeStep", [](GroundParams& p) { p.timeStep = 0; });
  expectRefused("gravity", [](GroundParams& p) { p.gravity = -1; });
  expectRefused("damping", [](GroundParams& p) { p.damping = 2; });
  expectRefused("maxIterations", [](GroundParams& p) { p.maxIterations = 0; });
  expectRefused("smoothingSlope", [](GroundParams& p) { p.smoothingSlope = -1; });
  expectRefused("smoothingReach", [](GroundParams& p) { p.smoothingReach = 11; });
  expectRefused("smrfCell", [](GroundParams& p) { p.smrfCell = 0; });
  expectRefused("smrfSlope", [](GroundParams& p) { p.smrfSlope = -1; });
  expectRefused("smrfWindow", [](GroundParams& p) { p.smrfWindow = 1e6; });
  expectRefused("smrfThreshold", [](GroundParams& p) { p.smrfThreshold = -1; });
  expectRefused("smrfScale", [](GroundParams& p) { p.smrfScale = -1; });
}

TEST(GroundParams, AClothThatWouldRestAtOnceIsRefused)
{
  expectRefused("restMove", [](GroundParams& p) { p.gravity = 0.01; });
  expectRefused("restMove", [](GroundParams& p) { p.restMove = 0.04; });
}
