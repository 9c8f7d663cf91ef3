#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "StepScans.h"
#include "step_grid/CStepGridMap2D.h"
#include "support/TempDir.h"

// The made-up class in programs that are not linked to it: its plugin and ours are preloaded.

using namespace step_grid;
using namespace step_grid::testing;
using namespace mrpt_mapconv::testing;

namespace
{
/** Names, and a path to search: LD_PRELOAD's own paths may have no spaces. */
const std::string kSearch = "LD_LIBRARY_PATH=\"$(dirname '" STEP_GRID_LIBRARY
                            "')\":\"$(dirname '" MRPT_MAPCONV_LIBRARY "')\" ";

void writeInputs(const TempDir& dir)
{
  std::ofstream(dir.path("step.ini"))
      << "[MappingApplication]\nstepGrid_count = 1\n"
         "[MappingApplication_stepGrid_00_creationOpts]\nresolution = 0.1\n"
         "[MappingApplication_stepGrid_00_insertOpts]\nmaxStep = 0.2\n";
  mrpt::maps::CSimpleMap map;
  for (const float x : {0.0f, 1.0f})
  {
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(std::make_shared<mrpt::obs::CObservationPointCloud>(kerbScan()));
    mrpt::poses::CPose3DPDFGaussian pose;
    pose.mean = mrpt::poses::CPose3D(static_cast<double>(x), 0, 0);
    map.insert(pose, *frame);
  }
  ASSERT_TRUE(map.saveToFile(dir.path("kerbs.simplemap")));
}

int run(const TempDir& dir, const std::string& command)
{
  return std::system(("cd '" + dir.path() + "' && " + command + " </dev/null >log 2>&1").c_str());
}

void expectMap(const TempDir& dir)
{
  mrpt::io::CFileGZInputStream file(dir.path("out_gridmap_no00.gridmap"));
  ASSERT_TRUE(file.fileOpenCorrectly());
  CStepGridMap2D map;
  mrpt::serialization::archiveFrom(file) >> map;
  for (const float kerb : {0.55f, 1.55f}) EXPECT_LT(map.getPos(kerb, 0.25f), 0.1f);
  EXPECT_GT(map.getPos(0.05f, 0.05f), 0.9f);
  for (const char* ending : {"_layers.tif", "_height.png", "_occupancy.png"})
    EXPECT_TRUE(
        std::filesystem::exists(dir.path(std::string("out_step_grid__CStepGridMap2D_00") + ending)))
        << ending;
}
}  // namespace

TEST(StepGridInMrpt, Observations2mapBuildsItWithBothPluginsPreloaded)
{
  const TempDir dir;
  writeInputs(dir);
  ASSERT_EQ(run(dir, kSearch + "LD_PRELOAD=\"libmrpt_mapconv.so libstep_grid.so\" "
                               "observations2map step.ini kerbs.simplemap out"),
            0)
      << readBytes(dir.path("log"));
  expectMap(dir);
}

#ifdef MAPCONV_PROGRAM
TEST(StepGridInMrpt, MapconvRunsAndDescribesItWithItsPluginPreloaded)
{
  const TempDir dir;
  writeInputs(dir);
  const std::string mapconv = kSearch + "LD_PRELOAD=libstep_grid.so '" MAPCONV_PROGRAM "' ";
  ASSERT_EQ(run(dir, mapconv + "run -- observations2map step.ini kerbs.simplemap out"), 0)
      << readBytes(dir.path("log"));
  EXPECT_EQ(readBytes(dir.path("log")).find("warning"), std::string::npos);
  expectMap(dir);

  ASSERT_EQ(run(dir, mapconv + "info out_gridmap_no00.gridmap --json"), 0);
  const auto json = readBytes(dir.path("log"));
  EXPECT_TRUE(contains(json, "\"kind\": \"step_grid::CStepGridMap2D\"")) << json;
  EXPECT_TRUE(
      contains(json, "\"layers\": {\"height\": \"Lowest point [m]\", \"occupancy\": \"Steps\"}"))
      << json;
}
#endif
