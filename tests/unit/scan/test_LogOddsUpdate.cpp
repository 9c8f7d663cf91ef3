#include <gtest/gtest.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "HandScan.h"
#include "support/ThrownMessage.h"

namespace
{
using namespace mrpt_mapconv;
using scan::LogOddsUpdate;
using scan::UpdateParams;
using test::HandScan;
using test::thrownMessage;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
using Cells = std::vector<std::int8_t>;

// The paper's profile has probabilities 0 and 1; these stand in for them by measurement.
TEST(LogOddsUpdate, DefaultUnits)
{
  const UpdateParams params;
  EXPECT_EQ(params.pHit, 0.7);
  EXPECT_EQ(params.pMiss, 0.45);
  EXPECT_EQ(params.pMin, 0.03);
  EXPECT_EQ(params.pMax, 0.97);
  const LogOddsUpdate update;
  EXPECT_EQ(update.hit(), 14);
  EXPECT_EQ(update.miss(), 3);
  EXPECT_EQ(update.lowest(), -55);
  EXPECT_EQ(update.highest(), 55);
}

LogOddsUpdate updateOf(double pHit, double pMiss, double pMin = 0.03, double pMax = 0.97)
{
  UpdateParams params;
  params.pHit = pHit, params.pMiss = pMiss, params.pMin = pMin, params.pMax = pMax;
  return LogOddsUpdate(params);
}

const LogOddsUpdate kTypical = updateOf(0.9, 0.35);  // 35 and 10 units

TEST(LogOddsUpdate, UnitsAreRoundedAlikeOnBothSides)
{
  for (double p = 0.53; p < 0.96; p += 0.01)
  {
    const LogOddsUpdate update = updateOf(p, 1 - p);
    EXPECT_EQ(update.hit(), std::lround(16 * std::log(p / (1 - p)))) << p;
    EXPECT_EQ(update.miss(), update.hit()) << p;
  }
  EXPECT_EQ(updateOf(0.5156, 0.4844).hit(), 1);
  EXPECT_EQ(updateOf(0.5156, 0.4844).miss(), 1);
}

TEST(LogOddsUpdate, LimitsAreTheOutermostUnitsWithinTheProbabilities)
{
  // units count log-odds of being free
  const auto probability = [](int unit) { return 1 / (1 + std::exp(unit / 16.0)); };
  for (const double pMin : {0.01, 0.03, 0.12, 0.3})
    for (const double pMax : {0.7, 0.9, 0.97, 0.995})
    {
      SCOPED_TRACE(std::to_string(pMin) + " … " + std::to_string(pMax));
      const LogOddsUpdate update = updateOf(0.6, 0.4, pMin, pMax);
      EXPECT_LE(probability(update.lowest()), pMax);
      EXPECT_GT(probability(update.lowest() - 1), pMax);
      EXPECT_GE(probability(update.highest()), pMin);
      EXPECT_LT(probability(update.highest() + 1), pMin);
    }
}

TEST(LogOddsUpdate, LimitsFitIntoACell)
{
  const LogOddsUpdate update = updateOf(0.9, 0.1, 1e-9, 1 - 1e-9);
  EXPECT_GE(update.lowest(), -128);
  EXPECT_LT(update.lowest(), -120);
  EXPECT_LE(update.highest(), 127);
  EXPECT_GT(update.highest(), 120);
}

/** "S.o": two free cells, then an occupied one. */
const scan::ScanProfile& threeCells()
{
  static const scan::ScanProfile profile = HandScan({"S.o"}).compute();
  return profile;
}

/** What one scan makes of a row of three cells; the first two are free. */
Cells updated(const LogOddsUpdate& update, Cells cells)
{
  update.apply(threeCells(), {1.0, 0, 0, 3, 1}, cells.data());
  return cells;
}

TEST(LogOddsUpdate, RaisesFreeCellsAndLowersOccupiedOnes)
{
  EXPECT_EQ(updated(kTypical, {0, 20, 0}), (Cells{10, 30, -35}));
  EXPECT_EQ(updated(updateOf(0.6, 0.2), {-50, 5, 7}), (Cells{-28, 27, 1}));
}

TEST(LogOddsUpdate, KeepsCellsWithinTheLimits)
{
  EXPECT_EQ(updated(kTypical, {45, 46, -20}), (Cells{55, 55, -55}));
  EXPECT_EQ(updated(kTypical, {55, 54, -21}), (Cells{55, 55, -55}));
  EXPECT_EQ(updated(kTypical, {55, 55, -55}), (Cells{55, 55, -55}));
}

TEST(LogOddsUpdate, CellsBeyondTheLimitsAreNotPulledBack)
{
  // by no update away from the middle …
  EXPECT_EQ(updated(kTypical, {56, 100, -70}), (Cells{56, 100, -70}));
  // … and by one towards it only as far as that goes
  EXPECT_EQ(updated(kTypical, {-100, -60, 120}), (Cells{-90, -50, 85}));
}

TEST(LogOddsUpdate, RawCellsAtTheLimitsOfTheirTypeDoNotWrap)
{
  EXPECT_EQ(updated(kTypical, {127, 127, -128}), (Cells{127, 127, -128}));
  EXPECT_EQ(updated(kTypical, {-128, -127, 127}), (Cells{-118, -117, 92}));
  const LogOddsUpdate strong = updateOf(0.999, 0.001, 0.0005, 0.9995);  // 111 units
  EXPECT_EQ(updated(strong, {127, 30, -30}), (Cells{127, 121, -121}));
  EXPECT_EQ(updated(strong, {-128, -128, 127}), (Cells{-17, -17, 16}));
}

TEST(LogOddsUpdate, ChangesNoOtherCells)
{
  // the profile's cells are (0, 0) … (2, 0); the grid begins at (-2, -1) and is 6 x 3
  Cells cells(18, 5);
  kTypical.apply(threeCells(), {1.0, -2, -1, 6, 3}, cells.data());
  EXPECT_EQ(cells, (Cells{5, 5, 5, 5, 5, 5,      //
                          5, 5, 15, 15, -30, 5,  //
                          5, 5, 5, 5, 5, 5}));
}

TEST(LogOddsUpdate, WideProfilesAreAppliedWhole)
{
  // rows of more than one word of bits, at all positions of the words
  for (int shift = 0; shift < 70; ++shift)
  {
    const std::string row = "S" + std::string(150, '.') + "o";
    HandScan scan({row});
    scan.params.maxRange = 200;
    scan.params.reflectionFilter = false;
    Cells cells(static_cast<std::size_t>(shift) + 160, 0);
    kTypical.apply(scan.compute(), {1.0, -shift, 0, shift + 160, 1}, cells.data());
    for (int kx = -shift; kx < 160; ++kx)
      ASSERT_EQ(cells[static_cast<std::size_t>(kx + shift)], kx < 0 || kx > 151 ? 0
                                                             : kx == 151        ? -35
                                                                                : 10)
          << "cell " << kx << ", shift " << shift;
  }
}

TEST(LogOddsUpdate, FrameThatDoesNotHoldTheProfileIsRefused)
{
  for (const grid::GridFrame& frame :
       {grid::GridFrame{1.0, 1, 0, 5, 3}, grid::GridFrame{1.0, 0, 0, 2, 5},
        grid::GridFrame{1.0, 0, 1, 3, 3}, grid::GridFrame{1.0, -3, -3, 10, 3}, grid::GridFrame{}})
  {
    Cells cells(frame.size(), 5);
    EXPECT_THROW(kTypical.apply(threeCells(), frame, cells.data()), std::invalid_argument)
        << frame.x0 << ", " << frame.y0 << ", " << frame.width << "x" << frame.height;
    EXPECT_EQ(cells, Cells(frame.size(), 5)) << "nothing may have changed";
  }
}

TEST(LogOddsUpdate, ScanThatSaysNothingFitsAnyFrame)
{
  const scan::ScanProfile nothing = HandScan({"S.."}).compute();
  Cells cells(4, 5);
  kTypical.apply(nothing, {1.0, 100, 100, 2, 2}, cells.data());
  EXPECT_EQ(cells, Cells(4, 5));
  EXPECT_NO_THROW(kTypical.apply(nothing, {}, nullptr));
}

struct BadValue
{
  const char *name, *value;
  std::function<void(UpdateParams&)> set;
};

TEST(LogOddsUpdate, BadValuesAreNamed)
{
  const BadValue cases[] = {
      {"pHit", "0.5", [](UpdateParams& p) { p.pHit = 0.5; }},
      {"pHit", "0.25", [](UpdateParams& p) { p.pHit = 0.25; }},
      {"pHit", "1", [](UpdateParams& p) { p.pHit = 1; }},
      {"pHit", "1.5", [](UpdateParams& p) { p.pHit = 1.5; }},
      {"pHit", "nan", [](UpdateParams& p) { p.pHit = kNaN; }},
      {"pHit", "0.505", [](UpdateParams& p) { p.pHit = 0.505; }},  // a third of a unit
      {"pMiss", "0.5", [](UpdateParams& p) { p.pMiss = 0.5; }},
      {"pMiss", "0.75", [](UpdateParams& p) { p.pMiss = 0.75; }},
      {"pMiss", "0", [](UpdateParams& p) { p.pMiss = 0; }},
      {"pMiss", "-0.5", [](UpdateParams& p) { p.pMiss = -0.5; }},
      {"pMiss", "nan", [](UpdateParams& p) { p.pMiss = kNaN; }},
      {"pMiss", "0.495", [](UpdateParams& p) { p.pMiss = 0.495; }},
      {"pMin", "0.5", [](UpdateParams& p) { p.pMin = 0.5; }},
      {"pMin", "0.75", [](UpdateParams& p) { p.pMin = 0.75; }},
      {"pMin", "-0.5", [](UpdateParams& p) { p.pMin = -0.5; }},
      {"pMin", "nan", [](UpdateParams& p) { p.pMin = kNaN; }},
      {"pMax", "0.5", [](UpdateParams& p) { p.pMax = 0.5; }},
      {"pMax", "0.25", [](UpdateParams& p) { p.pMax = 0.25; }},
      {"pMax", "1.5", [](UpdateParams& p) { p.pMax = 1.5; }},
      {"pMax", "nan", [](UpdateParams& p) { p.pMax = kNaN; }},
      {"pHit", "0.99", [](UpdateParams& p) { p.pHit = 0.99; }},  // above pMax
      {"pHit", "0.7", [](UpdateParams& p) { p.pMax = 0.6; }},
      {"pMiss", "0.01", [](UpdateParams& p) { p.pMiss = 0.01; }},  // below pMin
      {"pMiss", "0.45", [](UpdateParams& p) { p.pMin = 0.46; }},
  };
  for (const BadValue& bad : cases)
  {
    SCOPED_TRACE(std::string(bad.name) + " = " + bad.value);
    UpdateParams params;
    bad.set(params);
    test::expectNames(
        thrownMessage<std::invalid_argument>([&] { const LogOddsUpdate update(params); }), bad.name,
        bad.value);
  }
  EXPECT_NO_THROW(UpdateParams().check());
}

}  // namespace
