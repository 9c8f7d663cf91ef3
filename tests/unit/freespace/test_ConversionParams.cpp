#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/ConversionParams.h>

#include <cctype>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace
{
using mrpt_mapconv::freespace::ConversionParams;
using mrpt_mapconv::freespace::FloorFrom;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ConversionParams, DefaultsLookForStepsAndForGroundThatWasSeen)
{
  const ConversionParams params;
  EXPECT_FALSE(params.maxStep);
  EXPECT_TRUE(params.looksForSteps());
  EXPECT_EQ(params.floorFrom, FloorFrom::Seen);
  EXPECT_NO_THROW(params.check());
}

TEST(ConversionParams, ThePapersAreItsTable)
{
  const auto params = ConversionParams::paper();
  EXPECT_EQ(params.minClearance, 1.0);
  EXPECT_EQ(params.minOccupancy, 0.5);
  EXPECT_EQ(params.slopeWindow, 2);
  EXPECT_EQ(params.maxSlope, 2.0);
  EXPECT_EQ(params.maxStep, 0.0);
  EXPECT_FALSE(params.looksForSteps());
  EXPECT_EQ(params.floorFrom, FloorFrom::LowestFree);
}

TEST(ConversionParams, TakingThePapersLeavesWhatThePaperDoesNotHave)
{
  ConversionParams params;
  params.minClearance = 3, params.minOccupancy = 0, params.slopeWindow = 9, params.maxSlope = 7;
  params.maxStep = 0.4, params.maxGap = 5;
  params.reading.unknown = mrpt_mapconv::voxel::Unknown::Free;
  params.takeNamedSet();
  EXPECT_EQ(params.minClearance, 1.0);
  EXPECT_EQ(params.minOccupancy, 0.5);
  EXPECT_EQ(params.slopeWindow, 2);
  EXPECT_EQ(params.maxSlope, 2.0);
  EXPECT_EQ(params.maxStep, 0.0);
  EXPECT_EQ(params.floorFrom, FloorFrom::LowestFree);
  EXPECT_EQ(params.maxGap, 5);
  EXPECT_EQ(params.reading.unknown, mrpt_mapconv::voxel::Unknown::Free);
}

int minRun(double minClearance, double resolution)
{
  ConversionParams params;
  params.minClearance = minClearance;
  return params.minRunVoxels(resolution);
}

TEST(ConversionParams, FreeRunsAreCountedInWholeVoxels)
{
  EXPECT_EQ(minRun(1.0, 0.1), 10);
  EXPECT_EQ(minRun(1.0, 0.3), 4);
  EXPECT_EQ(minRun(0.9, 0.3), 3);
  EXPECT_EQ(minRun(0.91, 0.3), 4);
  EXPECT_EQ(minRun(0.25, 0.1), 3);
}

TEST(ConversionParams, AnyRunIsAtLeastOneVoxel)
{
  EXPECT_EQ(minRun(0.0, 0.1), 1);
  EXPECT_EQ(minRun(0.03, 0.1), 1);
  EXPECT_EQ(minRun(0.1, 0.1), 1);
}

TEST(ConversionParams, RoundingErrorsOfTheQuotientDoNotAddAVoxel)
{
  // 0.56/0.08 and 2.1/0.3 are 7.000000000000001 in double
  EXPECT_EQ(minRun(0.56, 0.08), 7);
  EXPECT_EQ(minRun(2.1, 0.3), 7);
  EXPECT_EQ(minRun(0.35, 0.07), 5);
  // the tolerance is a millionth of a voxel
  EXPECT_EQ(minRun(1.00000009, 0.1), 10);
  EXPECT_EQ(minRun(1.0000002, 0.1), 11);
}

int stepVoxels(std::optional<double> maxStep, double resolution)
{
  ConversionParams params;
  params.maxStep = maxStep;
  return params.maxStepVoxels(resolution);
}

TEST(ConversionParams, HighestDifferenceThatIsNoStep)
{
  EXPECT_EQ(stepVoxels(0.2, 0.1), 2);
  EXPECT_EQ(stepVoxels(0.29, 0.1), 2);
  EXPECT_EQ(stepVoxels(0.31, 0.1), 3);
  EXPECT_EQ(stepVoxels(0.05, 0.1), 0);
  // 0.3/0.1 and 0.35/0.07 are a little less than whole in double
  EXPECT_EQ(stepVoxels(0.3, 0.1), 3);
  EXPECT_EQ(stepVoxels(0.35, 0.07), 5);
}

TEST(ConversionParams, AStepThatIsAutoOrOffIsAFifthOfAMetreOrAVoxel)
{
  for (const auto& step : {std::optional<double>(), std::optional<double>(0)})
  {
    EXPECT_EQ(stepVoxels(step, 0.05), 4);
    EXPECT_EQ(stepVoxels(step, 0.16), 1);
    EXPECT_EQ(stepVoxels(step, 0.2), 1);
    EXPECT_EQ(stepVoxels(step, 0.5), 1);
  }
  const ConversionParams params;
  EXPECT_EQ(params.stepHeight(0.1), 0.2);
  EXPECT_EQ(params.stepHeight(0.3), 0.3);
}

TEST(ConversionParams, LowestStepThatTheSlopeTestMarks)
{
  ConversionParams params;
  EXPECT_NEAR(params.minStep(0.1), 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(params.minStep(0.3), 2.0, 1e-12);
  params.slopeWindow = 1;
  EXPECT_NEAR(params.minStep(0.1), 0.4, 1e-12);
  params.slopeWindow = 4;
  params.maxSlope = 0.5;
  EXPECT_NEAR(params.minStep(0.05), 0.15, 1e-12);
}

TEST(ConversionParams, ValuesAtTheLimitsAreGood)
{
  ConversionParams params;
  params.minClearance = 0, params.minOccupancy = 0, params.maxSlope = 0, params.maxStep = 0;
  params.slopeWindow = 1;
  EXPECT_NO_THROW(params.check());
  params.minOccupancy = 1;
  params.slopeWindow = 100;
  EXPECT_NO_THROW(params.check());
}

/** Whether a text holds a number or name as a word of its own: "0", but not in "100". */
bool holdsWord(const std::string& text, const std::string& word)
{
  const auto inWord = [](char c)
  { return std::isalnum(static_cast<unsigned char>(c)) || c == '.'; };
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
  {
    const auto end = at + word.size();
    if ((at == 0 || !inWord(text[at - 1])) && (end == text.size() || !inWord(text[end])))
      return true;
  }
  return false;
}

struct BadValue
{
  const char *name, *value;
  std::function<void(ConversionParams&)> set;
};

TEST(ConversionParams, BadValuesAreNamed)
{
  const BadValue cases[] = {
      {"minClearance", "-0.5", [](ConversionParams& p) { p.minClearance = -0.5; }},
      {"minClearance", "nan", [](ConversionParams& p) { p.minClearance = kNaN; }},
      {"minClearance", "inf", [](ConversionParams& p) { p.minClearance = kInfinity; }},
      {"minOccupancy", "1.1", [](ConversionParams& p) { p.minOccupancy = 1.1; }},
      {"minOccupancy", "-0.1", [](ConversionParams& p) { p.minOccupancy = -0.1; }},
      {"minOccupancy", "nan", [](ConversionParams& p) { p.minOccupancy = kNaN; }},
      {"slopeWindow", "0", [](ConversionParams& p) { p.slopeWindow = 0; }},
      {"slopeWindow", "-3", [](ConversionParams& p) { p.slopeWindow = -3; }},
      {"slopeWindow", "101", [](ConversionParams& p) { p.slopeWindow = 101; }},
      {"maxSlope", "-2", [](ConversionParams& p) { p.maxSlope = -2; }},
      {"maxSlope", "nan", [](ConversionParams& p) { p.maxSlope = kNaN; }},
      {"maxSlope", "inf", [](ConversionParams& p) { p.maxSlope = kInfinity; }},
      {"maxStep", "-0.25", [](ConversionParams& p) { p.maxStep = -0.25; }},
      {"maxStep", "nan", [](ConversionParams& p) { p.maxStep = kNaN; }},
      {"maxStep", "inf", [](ConversionParams& p) { p.maxStep = kInfinity; }},
  };
  for (const BadValue& bad : cases)
  {
    ConversionParams params;
    bad.set(params);
    try
    {
      params.check();
      ADD_FAILURE() << bad.name << " = " << bad.value << " was accepted";
    }
    catch (const std::invalid_argument& e)
    {
      const std::string message = e.what();
      EXPECT_TRUE(holdsWord(message, bad.name)) << message;
      EXPECT_TRUE(holdsWord(message, bad.value)) << message;
    }
  }
}

}  // namespace
