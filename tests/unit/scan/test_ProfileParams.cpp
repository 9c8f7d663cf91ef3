#include <gtest/gtest.h>
#include <mrpt_mapconv/scan/ProfileParams.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "support/ThrownMessage.h"

namespace
{
using mrpt_mapconv::scan::Model;
using mrpt_mapconv::scan::ProfileParams;
using mrpt_mapconv::test::expectNames;
using mrpt_mapconv::test::thrownMessage;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/** Good ones: the defaults and a structure slice, which has no default. */
ProfileParams goodParams()
{
  ProfileParams params;
  params.structureMinZ = 2.25;
  params.structureMaxZ = 2.75;
  return params;
}

TEST(ProfileParams, DefaultsAreTheIssues)
{
  const ProfileParams params;
  EXPECT_EQ(params.model, Model::WholeShape);
  EXPECT_EQ(params.objectMinZ, 0.05);
  EXPECT_EQ(params.objectMaxZ, 1.5);
  EXPECT_TRUE(params.reflectionFilter);
  EXPECT_TRUE(std::isnan(params.structureMinZ));
  EXPECT_TRUE(std::isnan(params.structureMaxZ));
  EXPECT_EQ(params.minRange, 0.3);
  EXPECT_EQ(params.maxRange, 20);
  EXPECT_EQ(params.sectors, 0);
  EXPECT_EQ(params.structureGap, -1);
  EXPECT_EQ(params.structureTolerance, -1);
  EXPECT_NO_THROW(goodParams().check());
}

TEST(ProfileParams, FilterNeedsAStructureSlice)
{
  const auto message = [](double min, double max)
  {
    ProfileParams params;
    params.structureMinZ = min;
    params.structureMaxZ = max;
    return thrownMessage<std::invalid_argument>([&] { params.check(); });
  };
  EXPECT_TRUE(mrpt_mapconv::test::holdsWord(message(kNaN, kNaN), "structureMinZ"));
  EXPECT_NE(message(kNaN, kNaN).find("reflectionFilter"), std::string::npos)
      << "what to do without: " << message(kNaN, kNaN);
  EXPECT_TRUE(mrpt_mapconv::test::holdsWord(message(kNaN, 2.5), "structureMinZ"));
  EXPECT_TRUE(mrpt_mapconv::test::holdsWord(message(2.5, kNaN), "structureMaxZ"));
}

TEST(ProfileParams, WithoutTheFilterNoStructureSliceIsNeeded)
{
  ProfileParams params;
  params.reflectionFilter = false;
  EXPECT_NO_THROW(params.check());
}

TEST(ProfileParams, SlicesOverlapIfAHeightIsInBoth)
{
  const auto overlap = [](double min, double max)
  {
    ProfileParams params;
    params.structureMinZ = min;
    params.structureMaxZ = max;
    return params.slicesOverlap();
  };
  EXPECT_TRUE(overlap(1, 2));
  EXPECT_TRUE(overlap(-1, 4));
  EXPECT_FALSE(overlap(1.5, 2));  // they touch
  EXPECT_FALSE(overlap(-1, 0.05));
  EXPECT_FALSE(overlap(kNaN, kNaN));
}

TEST(ProfileParams, ValuesAtTheLimitsAreGood)
{
  ProfileParams params = goodParams();
  params.minRange = 0;
  params.sectors = 1;
  params.structureGap = 0;
  params.structureTolerance = 0;
  params.objectMinZ = -0.5;
  params.structureMinZ = params.objectMaxZ;  // slices may touch
  EXPECT_NO_THROW(params.check());
  params.structureMinZ = 1;  // and overlap
  EXPECT_NO_THROW(params.check());
}

struct BadValue
{
  const char *name, *value;
  std::function<void(ProfileParams&)> set;
};

TEST(ProfileParams, BadValuesAreNamed)
{
  const BadValue cases[] = {
      {"objectMinZ", "nan", [](ProfileParams& p) { p.objectMinZ = kNaN; }},
      {"objectMinZ", "inf", [](ProfileParams& p) { p.objectMinZ = kInfinity; }},
      {"objectMaxZ", "0.03125", [](ProfileParams& p) { p.objectMaxZ = 0.03125; }},
      {"objectMaxZ", "0.05", [](ProfileParams& p) { p.objectMaxZ = 0.05; }},
      {"objectMaxZ", "nan", [](ProfileParams& p) { p.objectMaxZ = kNaN; }},
      {"structureMaxZ", "2.125", [](ProfileParams& p) { p.structureMaxZ = 2.125; }},
      {"structureMaxZ", "2.25", [](ProfileParams& p) { p.structureMaxZ = 2.25; }},
      {"structureMinZ", "inf", [](ProfileParams& p) { p.structureMinZ = kInfinity; }},
      {"minRange", "-0.5", [](ProfileParams& p) { p.minRange = -0.5; }},
      {"minRange", "nan", [](ProfileParams& p) { p.minRange = kNaN; }},
      {"maxRange", "0", [](ProfileParams& p) { p.minRange = 0, p.maxRange = 0; }},
      {"maxRange", "-3", [](ProfileParams& p) { p.maxRange = -3; }},
      {"maxRange", "nan", [](ProfileParams& p) { p.maxRange = kNaN; }},
      {"maxRange", "inf", [](ProfileParams& p) { p.maxRange = kInfinity; }},
      {"minRange", "25", [](ProfileParams& p) { p.minRange = 25; }},
      {"minRange", "20", [](ProfileParams& p) { p.minRange = 20; }},
      {"sectors", "-4", [](ProfileParams& p) { p.sectors = -4; }},
      {"structureGap", "-0.5", [](ProfileParams& p) { p.structureGap = -0.5; }},
      {"structureGap", "nan", [](ProfileParams& p) { p.structureGap = kNaN; }},
      {"structureTolerance", "-0.5", [](ProfileParams& p) { p.structureTolerance = -0.5; }},
      {"structureTolerance", "nan", [](ProfileParams& p) { p.structureTolerance = kNaN; }},
      {"structureTolerance", "inf", [](ProfileParams& p) { p.structureTolerance = kInfinity; }},
  };
  for (const BadValue& bad : cases)
  {
    SCOPED_TRACE(std::string(bad.name) + " = " + bad.value);
    ProfileParams params = goodParams();
    bad.set(params);
    expectNames(thrownMessage<std::invalid_argument>([&] { params.check(); }), bad.name, bad.value);
  }
}

}  // namespace
