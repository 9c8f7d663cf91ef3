#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/core/bits_math.h>
#include <mrpt_mapconv/maps/GridInsertionOptions.h>
#include <mrpt_mapconv/scan/ScanInsertionOptions.h>

#include <array>
#include <cmath>
#include <functional>
#include <sstream>

#include "support/ScanFixtures.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using scan::TScanInsertionOptions;

namespace
{
const std::string kSlice = "structureMinZ = 2.2\nstructureMaxZ = 2.5\n";

TScanInsertionOptions read(const std::string& text)
{
  const mrpt::config::CConfigFileMemory ini("[insert]\n" + text);
  TScanInsertionOptions options;
  options.loadFromConfigFile(ini, "insert");
  return options;
}

TScanInsertionOptions unusual()
{
  TScanInsertionOptions options;
  options.profile = {scan::Model::ClosestPoint, 0.1, 1.4, false, 1.9, 2.3, 0.4, 9, 720, 0.02, 0.15};
  options.update = {0.8, 0.3, 0.05, 0.95};
  options.insert2D = false;
  return options;
}

void expectSame(const TScanInsertionOptions& a, const TScanInsertionOptions& b)
{
  EXPECT_EQ(a.profile.model, b.profile.model);
  EXPECT_EQ(a.profile.objectMinZ, b.profile.objectMinZ);
  EXPECT_EQ(a.profile.objectMaxZ, b.profile.objectMaxZ);
  EXPECT_EQ(a.profile.reflectionFilter, b.profile.reflectionFilter);
  EXPECT_EQ(a.profile.structureMinZ, b.profile.structureMinZ);
  EXPECT_EQ(a.profile.structureMaxZ, b.profile.structureMaxZ);
  EXPECT_EQ(a.profile.minRange, b.profile.minRange);
  EXPECT_EQ(a.profile.maxRange, b.profile.maxRange);
  EXPECT_EQ(a.profile.sectors, b.profile.sectors);
  EXPECT_DOUBLE_EQ(a.profile.structureGap, b.profile.structureGap);  // by way of degrees
  EXPECT_EQ(a.profile.structureTolerance, b.profile.structureTolerance);
  EXPECT_EQ(a.update.pHit, b.update.pHit);
  EXPECT_EQ(a.update.pMiss, b.update.pMiss);
  EXPECT_EQ(a.update.pMin, b.update.pMin);
  EXPECT_EQ(a.update.pMax, b.update.pMax);
  EXPECT_EQ(a.insert2D, b.insert2D);
}
}  // namespace

TEST(ScanInsertionOptions, DefaultsAreThoseOfTheMethod)
{
  const auto options = read(kSlice);
  EXPECT_EQ(options.profile.model, scan::Model::WholeShape);
  EXPECT_EQ(options.profile.objectMinZ, 0.05);
  EXPECT_EQ(options.profile.objectMaxZ, 1.5);
  EXPECT_TRUE(options.profile.reflectionFilter);
  EXPECT_EQ(options.profile.structureMinZ, 2.2);
  EXPECT_EQ(options.profile.structureMaxZ, 2.5);
  EXPECT_EQ(options.profile.minRange, 0.3);
  EXPECT_EQ(options.profile.maxRange, 20);
  EXPECT_EQ(options.profile.sectors, 0);
  EXPECT_EQ(options.profile.structureGap, -1);
  EXPECT_EQ(options.profile.structureTolerance, -1);
  EXPECT_EQ(options.update.pMin, 0.03);
  EXPECT_EQ(options.update.pMax, 0.97);
  EXPECT_TRUE(options.insert2D);
}

TEST(ScanInsertionOptions, ReadsEveryKey)
{
  auto expected = unusual();
  expected.profile.structureGap = mrpt::DEG2RAD(1.5);
  expectSame(read("model = closestPoint // nearest\nobjectMinZ = 0.1\nobjectMaxZ = 1.4\n"
                  "reflectionFilter = false ; off\nstructureMinZ = 1.9\nstructureMaxZ = 2.3\n"
                  "minRange = 0.4\nmaxRange = 9\nsectors = 720\nstructureGap = 1.5\n"
                  "structureTolerance = 0.15\npHit = 0.8\npMiss = 0.3\npMin = 0.05\npMax = 0.95\n"
                  "insert2D = no\n"),
             expected);
}

TEST(ScanInsertionOptions, TheObjectSliceEndsAtTheRobotsHeight)
{
  EXPECT_EQ(read(kSlice + "robotHeight = 0.8\n").profile.objectMaxZ, 0.8);
  EXPECT_EQ(read(kSlice + "robotHeight = 0.8\nobjectMaxZ = 0.8\n").profile.objectMaxZ, 0.8);
  EXPECT_EQ(read(kSlice + "objectMinZ = 2\nrobotHeight = 2.1\n").profile.objectMinZ, 2);
  const auto said = messageOf([] { read(kSlice + "robotHeight = 0.8\nobjectMaxZ = 1.1\n"); });
  EXPECT_TRUE(contains(said, "robotHeight = '0.8'") && contains(said, "objectMaxZ = 1.1 m"))
      << said;
}

TEST(ScanInsertionOptions, TheKeyThatIsBlamedIsOneThatIsThere)
{
  for (const auto& [text, begin, end] : std::vector<std::array<std::string, 3>>{
           {"objectMinZ = 2\n", "objectMinZ = '2'", "below objectMaxZ = 1.5 m"},
           {"objectMaxZ = 0.01\n", "objectMaxZ = '0.01'", "above objectMinZ = 0.05 m"},
           {"robotHeight = 0.01\n", "robotHeight = '0.01'", "above objectMinZ = 0.05 m"},
           {"objectMinZ = 2\nrobotHeight = 1\n", "robotHeight = '1'", "above objectMinZ = 2 m"},
           {"maxRange = 0.2\n", "maxRange = '0.2'", "above minRange = 0.3 m"}})
  {
    const auto said = messageOf([&text = text] { read(kSlice + text); });
    EXPECT_TRUE(contains(said, "section 'insert': " + begin) && contains(said, end)) << said;
  }
}

TEST(ScanInsertionOptions, ModelsHaveTheirNamesInTheIni)
{
  EXPECT_EQ(params::textOf(scan::Model::WholeShape), "wholeShape");
  EXPECT_EQ(params::textOf(scan::Model::ClosestPoint), "closestPoint");
  for (const auto& name : namesOf(scan::Model()))
    EXPECT_EQ(params::textOf(read(kSlice + "model = " + name + "\n").profile.model), name);
}

TEST(ScanInsertionOptions, MaxRangeHasToFitTheCells)
{
  auto options = read(kSlice);
  EXPECT_NO_THROW(options.check(0.002));
  try
  {
    options.check(0.001);
    ADD_FAILURE() << "no exception";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(error.what(),
                 "maxRange = 20 is not valid: with resolution = 0.001 m it must be at most 10 m "
                 "(10000 cells)");
  }
  options.profile.maxRange = -1;
  EXPECT_THROW(options.check(0.05), std::invalid_argument);
}

TEST(ScanInsertionOptions, WhatIsSavedReadsTheSame)
{
  for (const double gap : {-1.0, 0.02, 0.0123456789012})
  {
    auto options = unusual();
    options.profile.structureGap = gap;
    for (double* value :
         {&options.profile.objectMinZ, &options.profile.objectMaxZ, &options.profile.structureMinZ,
          &options.profile.structureMaxZ, &options.profile.minRange, &options.profile.maxRange,
          &options.profile.structureTolerance, &options.update.pHit, &options.update.pMiss,
          &options.update.pMin, &options.update.pMax})
      *value *= 1.0123456789012345;
    mrpt::config::CConfigFileMemory ini;
    options.saveToConfigFile(ini, "insert");
    TScanInsertionOptions again;
    again.loadFromConfigFile(ini, "insert");
    expectSame(again, options);
  }
  mrpt::config::CConfigFileMemory ini;
  unusual().saveToConfigFile(ini, "insert");
  EXPECT_EQ(ini.read_string("insert", "minRange", ""), "0.4") << "no more digits than needed";
}

TEST(ScanInsertionOptions, AStreamBringsThemBack)
{
  for (const auto& options : {unusual(), TScanInsertionOptions()})
  {
    mrpt::io::CMemoryStream memory;
    auto archive = mrpt::serialization::archiveFrom(memory);
    options.writeToStream(archive);
    memory.Seek(0);
    auto again = unusual();
    again.readFromStream(archive);
    EXPECT_EQ(std::isnan(again.profile.structureMinZ), std::isnan(options.profile.structureMinZ));
    if (!std::isnan(options.profile.structureMinZ)) expectSame(again, options);
  }
}

TEST(ScanInsertionOptions, AnUnknownVersionOrModelInAStreamIsAnError)
{
  for (const auto& [version, model] : {std::pair<int, int>{1, 0}, {0, 2}})
  {
    mrpt::io::CMemoryStream memory;
    auto archive = mrpt::serialization::archiveFrom(memory);
    archive << static_cast<std::uint8_t>(version) << static_cast<std::uint8_t>(model);
    for (int i = 0; i < 20; ++i) archive << 0.5;
    memory.Seek(0);
    TScanInsertionOptions options;
    const auto said = messageOf([&] { options.readFromStream(archive); });
    EXPECT_TRUE(contains(said, "unknown")) << said;
    EXPECT_EQ(options.profile.maxRange, 20);
  }
}

TEST(ScanInsertionOptions, ABadValueIsAnErrorThatNamesSectionKeyAndValue)
{
  for (const char* line : {"maxRange = 0",
                           "maxRange = -1",
                           "maxRange = 1,5",
                           "maxRange = nan",
                           "minRange = -1",
                           "minRange = 20",
                           "sectors = -4",
                           "sectors = 1.5",
                           "structureGap = 181",
                           "structureGap = -2",
                           "structureTolerance = -0.5",
                           "objectMinZ = low",
                           "objectMaxZ = 0.05",
                           "robotHeight = 0",
                           "reflectionFilter = maybe",
                           "model = nearest",
                           "pHit = 0.5",
                           "pHit = 1",
                           "pMiss = 0.5",
                           "pMiss = 0",
                           "pMin = 0.5",
                           "pMax = 0.5",
                           "pMax = 1.5",
                           "insert2D = 2"})
  {
    const std::string text = line;
    const auto key = text.substr(0, text.find(' ')), value = text.substr(text.rfind(' ') + 1);
    const auto said = messageOf([&] { read(kSlice + text + "\n"); });
    EXPECT_TRUE(contains(said, "section 'insert': " + key + " = ")) << text << ": " << said;
    EXPECT_TRUE(contains(said, value)) << text << ": " << said;
  }
  const auto inverted = messageOf([] { read("structureMinZ = 2.5\nstructureMaxZ = 2.2\n"); });
  EXPECT_TRUE(contains(inverted, "section 'insert': structureMaxZ = 2.2")) << inverted;
}

TEST(ScanInsertionOptions, TheStructureSliceIsNeededForTheFilterOnly)
{
  for (const auto& [text, key] : {std::pair<std::string, std::string>{"", "structureMinZ"},
                                  {"structureMinZ = 2\n", "structureMaxZ"},
                                  {"structureMaxZ = 2\n", "structureMinZ"}})
  {
    const auto said = messageOf([&text = text] { read(text); });
    EXPECT_TRUE(contains(said, "section 'insert': " + key + " is missing")) << said;
  }
  EXPECT_FALSE(read("reflectionFilter = false\n").profile.reflectionFilter);
}

TEST(ScanInsertionOptions, AnErrorLeavesThemAsTheyWere)
{
  auto options = unusual();
  const mrpt::config::CConfigFileMemory ini("[insert]\nmaxRange = 5\npMax = 7\n");
  EXPECT_THROW(options.loadFromConfigFile(ini, "insert"), std::runtime_error);
  expectSame(options, unusual());
}

TEST(ScanInsertionOptions, UnknownKeysAreNamedInAWarning)
{
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  read(kSlice + "maxrange = 7\n");
  const auto said = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  EXPECT_TRUE(contains(said, "section 'insert': unknown key 'maxrange'")) << said;
}

TEST(ScanInsertionOptions, AreDumpedByTheirNamesInTheIni)
{
  std::ostringstream text;
  unusual().dumpToTextStream(text);
  for (const char* key : {"model", "objectMinZ", "objectMaxZ", "reflectionFilter", "structureMinZ",
                          "structureMaxZ", "minRange", "maxRange", "sectors", "structureGap",
                          "structureTolerance", "pHit", "pMiss", "pMin", "pMax", "insert2D"})
    EXPECT_TRUE(contains(text.str(), "\n" + std::string(key) + " ")) << key;
}

/** MRPT's own reading is the twin. */
TEST(ScanInsertionOptions, MrptsOwnKeysAreReadAsMrptDoes)
{
  const mrpt::config::CConfigFileMemory ini(
      "[insert]\nmapAltitude=0.4\nuseMapAltitude=true\nmaxDistanceInsertion=12.5\n"
      "maxOccupancyUpdateCertainty=0.7\nmaxFreenessUpdateCertainty=0.6\n"
      "maxFreenessInvalidRanges=0.55\nconsiderInvalidRangesAsFreeSpace=false\ndecimation=3\n"
      "horizontalTolerance=1.5\nCFD_features_gaussian_size=2\nCFD_features_median_size=5\n"
      "wideningBeamsWithDistance=true\n");
  mrpt::maps::COccupancyGridMap2D::TInsertionOptions ours, mrpts;
  params::StrictSection section(ini, "insert");
  maps::readGridInsertionOptions(section, ours);
  mrpts.loadFromConfigFile(ini, "insert");
  std::ostringstream ourText, mrptsText, defaults;
  ours.dumpToTextStream(ourText);
  mrpts.dumpToTextStream(mrptsText);
  mrpt::maps::COccupancyGridMap2D::TInsertionOptions().dumpToTextStream(defaults);
  EXPECT_EQ(ourText.str(), mrptsText.str());
  EXPECT_NE(ourText.str(), defaults.str());
  EXPECT_EQ(ours.horizontalTolerance, mrpts.horizontalTolerance);
  EXPECT_EQ(ours.maxFreenessInvalidRanges, mrpts.maxFreenessInvalidRanges);
  EXPECT_TRUE(section.unknownKeys().empty());
}
