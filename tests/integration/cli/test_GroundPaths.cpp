#include <gtest/gtest.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "OctreeFiles.h"
#include "Program.h"
#include "Raster.h"
#include "StrictJson.h"
#include "support/TempDir.h"

// plan and lift of ground robots on maps whose ground was not seen everywhere.
namespace
{
using namespace mrpt_mapconv::testing;

class GroundPaths : public ::testing::Test
{
 protected:
  std::string map() const { return m_dir.path("map"); }
  std::string csv() const { return m_dir.path("path.csv"); }
  void convert(const std::string& file, const std::string& maxStep = "0.2")
  {
    const auto run =
        mapconv({"convert", file, "-o", map(), "--max-step", maxStep, "--floor-from", "seen"});
    ASSERT_EQ(0, run.status) << run.err;
  }
  /** 2 m × 0.6 m; of 0.8 m ≤ x < 1.1 m free space begins 0.1 m over the ground, unseen below. */
  void convertGap()
  {
    std::vector<std::vector<std::string>> columns(
        6, std::vector<std::string>(20, "o" + std::string(20, 'f')));
    for (auto& row : columns)
      for (std::size_t x = 8; x < 11; ++x) row[x] = "  " + std::string(19, 'f');
    writeTree(treeOf(0.1, columns, 0, 0), m_dir.path("gap.bt"));
    convert(m_dir.path("gap.bt"));
  }
  Outcome plan(const std::string& from, const std::string& to, const std::string& radius,
               std::vector<std::string> more = {})
  {
    more.insert(more.begin(), {"plan", map(), "--robot", "ground", "--from=" + from, "--to=" + to,
                               "--robot-radius", radius, "-o", csv()});
    return mapconv(more);
  }
  Outcome lift(const std::string& path, std::vector<std::string> more = {},
               const std::string& robot = "ground")
  {
    more.insert(more.begin(),
                {"lift", map(), path, "--robot", robot, "-o", m_dir.path("lifted.csv")});
    return mapconv(more);
  }
  /** A path file of two points. */
  std::string straight(const std::string& from, const std::string& to)
  {
    std::ofstream(m_dir.path("flat.csv")) << from << "\n" << to << "\n";
    return m_dir.path("flat.csv");
  }

  const std::string kShared = MRPT_MAPCONV_SHARED_DIR "/";
  TempDir m_dir;
};

TEST_F(GroundPaths, SayHowManyMetresLeadOverInferredGround)
{
  convertGap();
  const Outcome planned = plan("0.25,0.35", "1.75,0.35", "0.1");
  ASSERT_EQ(0, planned.status) << planned.err;
  const std::string words =
      "length       1.50 m, 1.50 m in 2D\n"
      "inferred     0.30 m of it in 2D lead over ground that was not seen but is inferred\n";
  EXPECT_TRUE(contains(planned.out, words)) << planned.out;
  const Outcome lifted = lift(csv());
  EXPECT_TRUE(contains(lifted.out, words)) << lifted.out << lifted.err;
  EXPECT_NEAR(0.3, parseJson(lift(csv(), {"--json"}).out)["inferredLength"].number, 1e-9);

  const std::string seen = straight("0.15,0.35", "0.75,0.35");
  EXPECT_FALSE(contains(lift(seen).out, "inferred"));
  EXPECT_EQ(0, parseJson(lift(seen, {"--json"}).out)["inferredLength"].number);
  const Outcome flown =
      lift(straight("0.35,0.35", "1.65,0.35"), {"--json", "--safety-radius", "0.1"}, "aerial");
  EXPECT_EQ(0, parseJson(flown.out)["inferredLength"].number) << "it does not stand on it";
}

TEST_F(GroundPaths, SceneWithoutAVoxelMapSaysWhatItsColoursMean)
{
  convertGap();
  std::filesystem::remove(map() + "/voxels.bt");
  const Outcome planned = plan("0.25,0.35", "1.75,0.35", "0.1");
  ASSERT_EQ(0, planned.status) << planned.err;
  mrpt::opengl::COpenGLScene scene;
  ASSERT_TRUE(scene.loadFromFile(m_dir.path("path.3Dscene")));
  EXPECT_EQ(1u, scene.getViewport()->getTextMessages().messages.size()) << "inferred ground";
}

TEST_F(GroundPaths, LiftTakesWhatPlanWritesOnRealMaps)
{
  const std::pair<const char*, const char*> maps[] = {
      {"geb079.bt", "0.16"}, {"real/casoplon.bt", "0.2"}, {"real/catec.bt", "0.2"}};
  for (const auto& [name, maxStep] : maps)
    if (!std::filesystem::exists(kShared + name)) GTEST_SKIP() << name << " is not there";
  int planned = 0;
  double inferred = 0;
  for (const auto& [name, maxStep] : maps)
  {
    convert(kShared + name, maxStep);
    const Raster raster = readRaster(map() + "/layers.tif");
    const auto& ground = raster.bands.at(4).cells;
    std::mt19937 rng(7);
    const auto place = [&]
    {
      int x = 0, y = 0;
      do
      {
        x = static_cast<int>(rng() % static_cast<unsigned>(raster.width));
        y = static_cast<int>(rng() % static_cast<unsigned>(raster.height));
      } while (ground[static_cast<std::size_t>(y * raster.width + x)] != 0);
      const double res = raster.transform[1];
      const double yMin = raster.transform[3] - raster.height * res;
      return std::to_string(raster.transform[0] + (x + 0.5) * res) + "," +
             std::to_string(yMin + (y + 0.5) * res);
    };
    for (int i = 0; i < 8; ++i)
    {
      const std::string from = place(), to = place();
      const Outcome way = plan(from, to, i % 2 ? "0" : "0.15", {"--json"});
      if (way.status != 0) continue;
      SCOPED_TRACE(name + (" from " + from) + " to " + to);
      const Outcome lifted = lift(csv(), {"--json"});
      ASSERT_EQ(0, lifted.status) << lifted.err;
      EXPECT_EQ(readBytes(csv()), readBytes(m_dir.path("lifted.csv")));
      const double metres = parseJson(lifted.out)["inferredLength"].number;
      EXPECT_NEAR(parseJson(way.out)["inferredLength"].number, metres, 1e-9);
      ++planned;
      inferred += metres;
    }
  }
  EXPECT_GT(planned, 8);
  EXPECT_GT(inferred, 5);
}

TEST_F(GroundPaths, EndAtACliffAndSayWhy)
{
  if (!std::filesystem::exists(kShared + "reports"))
    GTEST_SKIP() << kShared << "reports is not there";
  convert(kShared + "reports/cliff.bt");
  const std::string unseen = "nobody saw the ground there";
  const Outcome over = lift(straight("-5,0", "3,0"));
  EXPECT_EQ(1, over.status);
  EXPECT_TRUE(contains(over.err, "flat.csv: point 60 at (1.00, 0.00): " + unseen)) << over.err;
  const Outcome into = plan("-5,0", "3,0", "0.3");
  EXPECT_TRUE(contains(into.err, "goal (3, 0) m is in an unknown cell: " + unseen)) << into.err;
  const Outcome edge = plan("-5,0", "0.92,0", "0.3");
  EXPECT_TRUE(
      contains(edge.err, "goal (0.92, 0) m is in an occupied cell: it is the edge of a drop"))
      << edge.err;
  EXPECT_EQ(0, plan("-5,0", "0.5,0", "0.3").status);
}

TEST_F(GroundPaths, CutNoCornerOfGroundThatNobodySaw)
{
  const std::string file = kShared + "geb079.bt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  convert(file);
  const Raster raster = readRaster(map() + "/layers.tif");
  const double res = raster.transform[1];
  const double xMin = raster.transform[0], yMin = raster.transform[3] - raster.height * res;
  const auto at = [&](std::size_t band, int x, int y)
  { return raster.bands.at(band).cells[static_cast<std::size_t>(y * raster.width + x)]; };
  int cut = 0;
  for (int y = 1; y < raster.height && cut < 3; ++y)
    for (int x = 1; x < raster.width && cut < 3; ++x)
    {
      const double step = std::abs(at(5, x - 1, y) - at(5, x, y - 1));  // NaN without ground
      if (std::isnan(at(0, x, y)) || !std::isnan(at(5, x, y)) || !(step < 0.1)) continue;
      // from the cell on its left to the one below, just past its lower left corner
      const auto place = [&](double dx, double dy) {
        return std::to_string(xMin + (x + dx) * res) + "," + std::to_string(yMin + (y + dy) * res);
      };
      const std::string path = straight(place(-0.3, 0.4), place(0.4, -0.3));
      for (const bool hasVoxels : {true, false})
      {
        if (!hasVoxels) std::filesystem::rename(map() + "/voxels.bt", m_dir.path("away"));
        const Outcome lifted = lift(path);
        EXPECT_EQ(1, lifted.status) << lifted.out;
        EXPECT_TRUE(contains(lifted.err,
                             "on the straight way between two points, nobody saw the ground there"))
            << lifted.err;
      }
      std::filesystem::rename(m_dir.path("away"), map() + "/voxels.bt");
      ++cut;
    }
  EXPECT_EQ(3, cut);
}

TEST_F(GroundPaths, DoNotLeadThroughAPillarThatBeginsAboveTheGround)
{
  const std::string file = kShared + "real/casoplon.bt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  // at (12.3, 7.7) m something stands from 1.6 m on; free space begins above it, at 5 m
  convert(file);
  const Outcome into = plan("3,3", "12.3,7.7", "0");
  EXPECT_EQ(1, into.status);
  EXPECT_TRUE(contains(into.err, "is in an unknown cell: nobody saw the ground there")) << into.err;
  const Outcome over = lift(straight("12.3,7.3", "12.3,8.5"));
  EXPECT_EQ(1, over.status);
  EXPECT_TRUE(contains(over.err, "nobody saw the ground there")) << over.err;
}

}  // namespace
