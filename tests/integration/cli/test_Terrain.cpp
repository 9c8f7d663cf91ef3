#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "InsertRuns.h"
#include "OctreeFiles.h"
#include "Raster.h"
#include "StrictJson.h"

using namespace mrpt_mapconv::testing;

namespace
{
std::vector<std::string> operator+(std::vector<std::string> words,
                                   const std::vector<std::string>& more)
{
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/** Two levels of 1 x 1 m, at z = 0 up to x = 0.95 m and at z = 0.3 m beyond, and a ceiling 3 m up,
 * seen from 1 m above the robot's base. Step and sides lie between cells of 0.1 m. */
mrpt::obs::CObservation::Ptr step(double seconds)
{
  std::vector<mrpt::math::TPoint3Df> points;
  for (int ix = 0; ix < 80; ++ix)
    for (int iy = 0; iy < 40; ++iy)
    {
      const float x = -0.05f + 0.025f * (static_cast<float>(ix) + 0.5f);
      const float y = -0.05f + 0.025f * (static_cast<float>(iy) + 0.5f);
      points.emplace_back(x, y, ix < 40 ? 0 : 0.3f);
      if (ix % 10 == 0) points.emplace_back(x, y, 3);
    }
  return cloudOn(points, {0, 0, 1}, seconds);
}

class Terrain : public ::testing::Test
{
 protected:
  Terrain() { writeObjects(path("step.rawlog"), {step(0)}); }

  std::string path(const std::string& name) const { return m_dir.path(name); }
  Outcome terrain(const std::string& file, const std::vector<std::string>& flags = {}) const
  {
    return mapconv(
        std::vector<std::string>{"terrain", path(file), "-o", path("out"), "--resolution", "0.1"} +
        flags);
  }
  /** The summary of a run that succeeds and says nothing else. */
  JsonValue mapped(const std::vector<std::string>& flags = {}) const
  {
    const auto run = terrain("step.rawlog", flags + std::vector<std::string>{"--json"});
    EXPECT_EQ(0, run.status) << run.err;
    EXPECT_EQ("", run.err);
    return parseJson(run.out);
  }
  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name)) << text;
    return path(name);
  }
  /** A simplemap of step() whose keyframe's pose is that uncertain. */
  void writeSimpleMap(const std::string& name, double variance) const
  {
    mrpt::maps::CSimpleMap map;
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(step(0));
    mrpt::poses::CPose3DPDFGaussian pose;
    for (int i = 0; i < 6; ++i) pose.cov(i, i) = variance;
    map.insert(pose, *frame);
    ASSERT_TRUE(map.saveToFile(path(name)));
  }
  /** The mean of the finite cells of a band. */
  double meanOf(const std::string& band) const
  {
    const Raster raster = readRaster(path("out/layers.tif"));
    double sum = 0, count = 0;
    for (const auto& one : raster.bands)
      for (const double cell : one.cells)
        if (one.name == band && std::isfinite(cell))
        {
          sum += cell;
          ++count;
        }
    return sum / count;
  }

  TempDir m_dir;
};
}  // namespace

TEST_F(Terrain, writesLayersPicturesTablesMapsAndAScene)
{
  mapped();
  std::set<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(path("out")))
    names.insert(file.path().filename().string());
  EXPECT_EQ(names,
            (std::set<std::string>{
                "layers.tif", "height.png", "sigma.png", "plane.png", "leafSide.png", "slope.png",
                "traversability.png", "leaves.png", "traversability.gridmap", "traversability.pgm",
                "traversability.yaml", "planes.csv", "steps.csv", "map.3Dscene"}));
  const Raster raster = readRaster(path("out/layers.tif"));
  EXPECT_EQ(raster.width, 20);
  EXPECT_EQ(raster.height, 10);
  EXPECT_NEAR(raster.transform[0], -0.05, 1e-12) << "cells are centred on multiples of 0.1 m";
  EXPECT_NEAR(raster.transform[3], 0.95, 1e-12);
  std::string bands;
  for (const auto& band : raster.bands) bands += band.name + " ";
  EXPECT_EQ(bands, "height sigma plane leafSide slope traversability ");
}

TEST_F(Terrain, findsTheStep)
{
  const auto json = mapped();
  EXPECT_EQ(json["knownCells"].number, 200);
  EXPECT_EQ(json["planes"].number, 2);
  EXPECT_EQ(json["cellsInPlanes"].number, 200);
  EXPECT_EQ(json["steps"].number, 1);
  EXPECT_LT(json["leaves"].number, 100);
  EXPECT_EQ(json["scans3D"].number, 1);
  EXPECT_EQ(json["points"].number, 80 * 40);
  EXPECT_EQ(json["pointsBeyondLimits"].number, 8 * 40) << "the ceiling";
  // 0.3 m is more than maxStep: two rows of ten cells
  EXPECT_EQ(json["occupied"].number, 20);
  EXPECT_EQ(json["free"].number, 180);
  const auto steps = readBytes(path("out/steps.csv"));
  EXPECT_TRUE(contains(steps, "\n0,1,0.3000,1.0000,1.0000,0.9500,")) << steps;
  EXPECT_TRUE(contains(readBytes(path("out/planes.csv")), "\n1,100,1.4500,0.4500,0.3000,"));
}

TEST_F(Terrain, stockMrptReadsTheGridMapInPlace)
{
  mapped();
  mrpt::io::CFileGZInputStream file(path("out/traversability.gridmap"));
  mrpt::maps::COccupancyGridMap2D map;
  mrpt::serialization::archiveFrom(file) >> map;
  for (const float x : {0.0f, 0.5f, 0.84f, 1.06f, 1.9f}) EXPECT_GT(map.getPos(x, 0.5f), 0.9f) << x;
  for (const float x : {0.86f, 0.94f, 0.96f, 1.04f}) EXPECT_LT(map.getPos(x, 0.5f), 0.1f) << x;
  for (const float x : {-0.2f, 2.0f}) EXPECT_EQ(map.getPos(x, 0.5f), 0.5f) << x;
  EXPECT_TRUE(contains(readBytes(path("out/traversability.yaml")), "origin: [-0.05, -0.05, 0]"));
}

TEST_F(Terrain, theSummarySaysWhatThereIs)
{
  const auto run = terrain("step.rawlog", {"--max-step", "0.5"});
  ASSERT_EQ(0, run.status) << run.err;
  for (const char* line :
       {"cells        200 (20 x 10) of 0.1 m\n", "terrain      200 free (100.0 %)",
        "planes       2 with 200 cells (100.0 %)\n", "steps        1, 0.300 to 0.300 m high\n",
        "not default  maxStep = 0.5\n", "inserted     1 3D scans with 3200 points\n",
        "covariance   of the pose from heightSigma, rollSigma, pitchSigma\n",
        "left out     320 points beyond maxRange, minHeight and maxHeight\n", "seconds      load "})
    EXPECT_TRUE(contains(run.out, line)) << line << " in " << run.out;
}

TEST_F(Terrain, listsStepsBesideTheTruth)
{
  const auto world = write("step.ini",
                           "[world]\nbounds = -1 -1 -1  3 2 2\n"
                           "[box.floor]\nmin = -1 -1 -1\nmax = 3 2 0\n"
                           "[box.level]\nmin = 0.93 -1 0\nmax = 3 2 0.31\n"
                           "[box.top]\nmin = 2.2 -1 0\nmax = 3 2 0.5\n"
                           "[sensor.s]\nkind = scanner2D\nrate = 1\nmaxRange = 5\n"
                           "fieldOfView = 180\nrays = 10\n"
                           "[trajectory]\nposes = [0 0 0.5 1 0 0 0] [1 2.5 0.5 1 0 0 0]\n");
  const auto run = terrain("step.rawlog", {"--truth", world});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_TRUE(contains(run.out,
                       "true steps   2 on the robot's way, 1 found; largest error of heights 10.0 "
                       "mm, of depths 270.0 mm\n"
                       "  x [m]  y [m]   height  in map    depth  in map\n"
                       "   0.93   0.50    0.310    0.300    1.270    1.000\n"
                       "   2.20   0.50    0.190        -        -        -  not found\n"))
      << run.out;
  EXPECT_EQ(readBytes(path("out/true_steps.csv")),
            "x,y,directionX,directionY,trueHeight,height,trueDepth,depth\n"
            "0.9300,0.5000,1.0000,0.0000,0.3100,0.3000,1.2700,1.0000\n"
            "2.2000,0.5000,1.0000,0.0000,0.1900,,,\n");
  const auto json = mapped({"--truth", world});
  EXPECT_EQ(json["trueSteps"].number, 2);
  EXPECT_EQ(json["trueStepsFound"].number, 1);
  EXPECT_NEAR(json["worstStepHeightError"].number, 0.01, 1e-4);
  EXPECT_NEAR(json["worstStepDepthError"].number, 0.27, 1e-4);
}

TEST_F(Terrain, aWorldThatIsNoneIsAnErrorThatNamesIt)
{
  const auto run = terrain("step.rawlog", {"--truth", write("no.ini", "[world]\n")});
  EXPECT_EQ(1, run.status);
  expectWords(run, {"no.ini"});
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

TEST_F(Terrain, everyParameterIsInTheSummary)
{
  const auto json = mapped({"--max-height", "5", "--height-rule", "maximum", "--pitch-sigma", "2"});
  const auto& parameters = json["parameters"];
  EXPECT_EQ(parameters["maxHeight"].number, 5);
  EXPECT_EQ(parameters["heightRule"].text, "maximum");
  EXPECT_EQ(parameters["pitchSigma"].number, 2);
  EXPECT_EQ(parameters["planeTolerance"].number, 0.02);
  EXPECT_EQ(json["pointsBeyondLimits"].number, 0);
}

TEST_F(Terrain, iniSetsAndFlagsWin)
{
  const auto ini = write(
      "my.ini",
      "[map]\nresolution = 0.5\n[terrainInsertion]\nmaxHeight = 0.1\n[terrain]\nmaxStep = 0.4\n");
  const auto json = mapped({"-c", ini});
  EXPECT_EQ(json["resolution"].number, 0.1) << "that is a flag";
  EXPECT_EQ(json["knownCells"].number, 100);
  EXPECT_EQ(json["parameters"]["maxStep"].number, 0.4);
  EXPECT_EQ(mapped({"-c", ini, "--max-height", "2"})["knownCells"].number, 200);
}

TEST_F(Terrain, theShippedFileHoldsTheDefaults)
{
  const auto shipped = mapped({"-c", MRPT_MAPCONV_SOURCE_DIR "/config/terrainGrid/terrain.ini"});
  const auto plain = mapped();
  for (const auto& [key, value] : plain["parameters"].object)
  {
    EXPECT_EQ(shipped["parameters"][key].number, value.number) << key;
    EXPECT_EQ(shipped["parameters"][key].text, value.text) << key;
  }
}

TEST_F(Terrain, theCovarianceComesFromASimplemapThatHasOne)
{
  const auto sigmaOf = [&](const std::string& file)
  {
    const auto run = terrain(file, {"--min-plane-cells", "1000000", "--json"});
    EXPECT_EQ(0, run.status) << run.err;
    return std::pair{parseJson(run.out)["scansWithCovariance"].number, meanOf("sigma")};
  };
  writeSimpleMap("sure.simplemap", 1e-8);
  writeSimpleMap("unsure.simplemap", 0.01);
  writeSimpleMap("silent.simplemap", 0);
  const auto sure = sigmaOf("sure.simplemap"), unsure = sigmaOf("unsure.simplemap"),
             silent = sigmaOf("silent.simplemap");
  EXPECT_EQ(sure.first, 1);
  EXPECT_EQ(unsure.first, 1);
  EXPECT_EQ(silent.first, 0);
  EXPECT_GT(unsure.second, 3 * silent.second);
  EXPECT_LT(sure.second, silent.second);
}

TEST_F(Terrain, sigmasThatTheLogReplacesAreNamed)
{
  writeSimpleMap("sure.simplemap", 1e-8);
  const auto ini = write("my.ini", "[terrainInsertion]\nrollSigma = 1\n");
  const auto run = terrain("sure.simplemap", {"-c", ini, "--height-sigma", "0.1"});
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(run.err, "mapconv: warning: --height-sigma, rollSigma of " + ini + " have no effect: " +
                         path("sure.simplemap") + " has the covariance of each pose\n");
  EXPECT_EQ(terrain("step.rawlog", {"-c", ini, "--height-sigma", "0.1"}).err, "");
}

TEST_F(Terrain, scansIn2DAreLeftOutWithAWarning)
{
  writeObjects(path("both.rawlog"), {robotAt(0, 0), step(0), scan2D(0)});
  const auto run = terrain("both.rawlog");
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(run.err, "mapconv: warning: 1 2D scan is left out: they see no terrain\n");
}

TEST_F(Terrain, typosAreNamedInAWarning)
{
  const auto ini = write("my.ini", "[terrain]\nmaxSteps = 1\n[conversion]\nx = 1\n");
  const auto run = terrain("step.rawlog", {"-c", ini});
  EXPECT_EQ(0, run.status);
  EXPECT_TRUE(contains(run.err, "[terrain] unknown key 'maxSteps' has no effect")) << run.err;
  EXPECT_TRUE(contains(run.err,
                       "unknown section [conversion] has no effect; [terrainInsertion] and "
                       "[map] and [terrain] do"))
      << run.err;
}

TEST_F(Terrain, badIniValuesAreErrorsThatNameFileSectionKeyAndValue)
{
  for (const auto& [section, key, value] :
       std::vector<std::array<std::string, 3>>{{"map", "resolution", "big"},
                                               {"map", "maxGridCells", "0"},
                                               {"terrainInsertion", "maxRange", "-3"},
                                               {"terrainInsertion", "beamSigma", "2"},
                                               {"terrain", "hypotheses", "0"},
                                               {"terrain", "blockCells", "0"},
                                               {"terrain", "heightRule", "median"}})
  {
    const auto ini = write("bad.ini", "[" + section + "]\n" + key + " = " + value + "\n");
    const auto run = mapconv({"terrain", path("step.rawlog"), "-o", path("out"), "-c", ini});
    EXPECT_EQ(1, run.status) << key;
    expectWords(run, {ini, section, key, value, "must be"});
  }
}

TEST_F(Terrain, badFlagsAreStatus2AndNamed)
{
  for (const auto& [flag, value] :
       std::vector<std::pair<std::string, std::string>>{{"--resolution", "0"},
                                                        {"--hypotheses", "0"},
                                                        {"--block-cells", "0"},
                                                        {"--block-cells", "1.5"},
                                                        {"--min-plane-cells", "2"},
                                                        {"--max-range", "0"},
                                                        {"--range-sigma", "-1"},
                                                        {"--height-rule", "median"},
                                                        {"--threads", "-1"}})
  {
    const auto run = mapconv({"terrain", path("step.rawlog"), "-o", path("out"), flag, value});
    EXPECT_EQ(2, run.status) << flag;
    expectWords(run, {flag});
  }
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

TEST_F(Terrain, badInputIsOneErrorThatNamesItAndLeavesNoTrace)
{
  HandMap::write(path("hand.bt"));
  write("empty.rawlog", "");
  writeObjects(path("2d.rawlog"), {scan2D(0)});
  writeObjects(path("nan.rawlog"), {badPoint(NAN, 0)});
  for (const auto& [file, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"missing.rawlog", {"no such file"}},
           {"hand.bt", {"octree"}},
           {"empty.rawlog", {"empty.rawlog"}},
           {"2d.rawlog", {"no 3D scan"}},
           {"nan.rawlog", {"none of its scans says anything", "1: no usable point"}}})
  {
    const auto run = terrain(file);
    EXPECT_EQ(1, run.status) << file;
    auto all = words;
    all.push_back(file);
    EXPECT_EQ("", run.out);
    for (const auto& word : all) EXPECT_TRUE(contains(run.err, word)) << word << " in " << run.err;
    EXPECT_FALSE(std::filesystem::exists(path("out"))) << file;
  }
  const auto far = terrain("step.rawlog", {"--max-range", "0.1"});
  EXPECT_EQ(1, far.status);
  expectWords(far, {"1: no point within maxRange, minHeight and maxHeight"});
}

TEST_F(Terrain, layersThatWouldBeTooLargeAreAnErrorThatNamesTheScan)
{
  writeObjects(path("far.rawlog"), {robotAt(0, 0), step(0), robotAt(1e6, 1), step(1)});
  const auto run = terrain("far.rawlog", {"-c", write("my.ini", "[map]\nmaxGridCells = 1000\n")});
  EXPECT_EQ(1, run.status);
  expectWords(run, {"far.rawlog: scan 2 of 2: maxGridCells = 1000", "is the scan's pose right?"});
}

TEST_F(Terrain, anyNumberOfThreadsGivesTheSame)
{
  mapped({"--threads", "1"});
  const auto one = readBytes(path("out/layers.tif"));
  mapped({"--threads", "3"});
  EXPECT_EQ(one, readBytes(path("out/layers.tif")));
}
