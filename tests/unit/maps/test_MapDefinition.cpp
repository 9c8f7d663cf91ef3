#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/maps/MapDefinition.h>

#include "support/ScanFixtures.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::config::CConfigFileMemory;

namespace
{
struct Creation
{
  double resolution = 0.5, depth = 2;

  template <class S, class V>
  static void visit(S& c, V&& v)
  {
    v("resolution", c.resolution, "m", "size of a cell");
    v("depth", c.depth, "m", "made up");
  }
};

Creation read(const std::string& keys, mrpt::maps::TMapGenericParams& shared)
{
  const CConfigFileMemory ini("[map_dots_00_creationOpts]\n" + keys);
  maps::DefinitionSections sections(ini, "map_dots_00");
  Creation creation;
  sections.readCreation(creation, shared,
                        [&](const params::StrictSection& section)
                        {
                          if (creation.depth < 0) section.fail("depth", ">= 0");
                        });
  return creation;
}

std::string errorOf(const std::string& keys)
try
{
  mrpt::maps::TMapGenericParams shared;
  read(keys, shared);
  return "";
}
catch (const std::runtime_error& error)
{
  return error.what();
}

std::string saidAbout(const CConfigFileMemory& ini)
{
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  maps::DefinitionSections sections(ini, "map_dots_00");
  EXPECT_EQ(sections.name("_insertOpts"), "map_dots_00_insertOpts");
  sections.warnUnknown();
  return testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
}
}  // namespace

TEST(MapDefinition, ReadsHowAMapBegins)
{
  mrpt::maps::TMapGenericParams shared;
  const auto creation =
      read("resolution = 0.2\ndepth = 3\nenableSaveAs3DObject = no ; why\n", shared);
  EXPECT_EQ(creation.resolution, 0.2);
  EXPECT_EQ(creation.depth, 3);
  EXPECT_FALSE(shared.enableSaveAs3DObject);
  EXPECT_TRUE(shared.enableObservationInsertion);
}

TEST(MapDefinition, SaysWhichValueIsWrong)
{
  EXPECT_TRUE(contains(errorOf("resolution = 0\n"), "resolution = '0' is not valid"));
  EXPECT_TRUE(contains(errorOf("resolution = fine\n"), "resolution = 'fine' is not valid"));
  EXPECT_TRUE(contains(errorOf("depth = -1\n"), "depth = '-1' is not valid: it must be >= 0"))
      << errorOf("depth = -1\n");
  EXPECT_TRUE(contains(errorOf("depth = -1\n"), "map_dots_00_creationOpts"));
  EXPECT_TRUE(contains(errorOf("enableObservationInsertion = maybe\n"), "'maybe'"));
}

TEST(MapDefinition, WarnsOfSectionsThatNobodyReads)
{
  EXPECT_EQ(saidAbout(CConfigFileMemory("[map_dots_00_insertOpts]\na = 1\n[map_dots_01_x]\na=1\n"
                                        "[other]\na = 1\n")),
            "");
  const auto said = saidAbout(CConfigFileMemory("[map_dots_00_inserOpts]\na = 1\n"));
  EXPECT_TRUE(contains(said, "unknown section 'map_dots_00_inserOpts' has no effect")) << said;
}

TEST(MapDefinition, ResolutionsThatMrptCannotHoldAreRefused)
{
  EXPECT_EQ(maps::checkedResolution(0.05), 0.05);
  EXPECT_THROW(maps::checkedResolution(1e-5), std::invalid_argument);
  EXPECT_THROW(maps::checkedResolution(NAN), std::invalid_argument);
}
