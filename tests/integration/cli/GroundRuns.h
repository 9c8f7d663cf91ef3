#pragma once

#include <gtest/gtest.h>
#include <mrpt_mapconv/cloud/CloudFile.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "Program.h"
#include "Raster.h"
#include "StrictJson.h"
#include "support/TempDir.h"

namespace mrpt_mapconv::testing
{
/** Ground of 20 x 20 m that rises by 1/8 along x, with a point in the middle of each cell of
 * 0.25 m. A house with a level distance of 4 m from ground to roof hides the ground of 16 x 16 of
 * them; the points of a crown, 5 m above the ground of 8 x 8 cells, do not. Floats hold
 * all numbers. */
struct Hillside
{
  static constexpr int kCells = 80;  //!< along a side
  static constexpr int kHouse = 16 * 16, kCrown = 8 * 8;
  static constexpr int kGround = kCells * kCells - kHouse;  //!< points
  static constexpr int kPoints = kCells * kCells + kCrown;

  static double middle(int cell) { return 0.125 + 0.25 * cell; }
  static double ground(double x) { return x / 8; }
  static bool isHouse(double x, double y) { return x > 6 && x < 10 && y > 6 && y < 10; }
  static bool isCrown(double x, double y) { return x > 14 && x < 16 && y > 14 && y < 16; }

  /** With the classes that its points should get. */
  static cloud::PointCloud cloud()
  {
    cloud::PointCloud cloud;
    const auto add = [&cloud](double x, double y, double above)
    {
      cloud.x.push_back(x);
      cloud.y.push_back(y);
      cloud.z.push_back(ground(x) + above);
      cloud.classification.push_back(above > 0 ? cloud::kUnclassified : cloud::kGround);
    };
    for (int iy = 0; iy < kCells; ++iy)
      for (int ix = 0; ix < kCells; ++ix)
      {
        const double x = middle(ix), y = middle(iy);
        if (isCrown(x, y)) add(x, y, 5);
        add(x, y, isHouse(x, y) ? 4 : 0);
      }
    return cloud;
  }
  /** Without classes. */
  static cloud::PointCloud bareCloud()
  {
    cloud::PointCloud bare = cloud();
    bare.classification.clear();
    return bare;
  }
};

inline std::vector<std::string> operator+(std::vector<std::string> words,
                                          const std::vector<std::string>& more)
{
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/** Runs of `mapconv ground` into the folder `out`. */
class GroundRuns : public ::testing::Test
{
 protected:
  std::string path(const std::string& name) const { return m_dir.path(name); }
  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  void writeCloud(const std::string& name, const cloud::PointCloud& cloud) const
  {
    cloud::writeCloudFile(path(name), cloud);
  }

  Outcome ground(const std::string& file, const std::vector<std::string>& flags = {}) const
  {
    return mapconv(std::vector<std::string>{"ground", path(file), "-o", path("out")} + flags);
  }
  /** The summary of a run that succeeds and says nothing else. */
  JsonValue mapped(const std::string& file, const std::vector<std::string>& flags = {}) const
  {
    const auto run = ground(file, flags + std::vector<std::string>{"--json"});
    EXPECT_EQ(0, run.status) << run.err;
    EXPECT_EQ("", run.err);
    return parseJson(run.out);
  }
  /** One error of a run that leaves neither a folder nor a file. */
  void expectError(const std::string& file, const std::vector<std::string>& flags,
                   const std::vector<std::string>& words) const
  {
    const auto before = m_dir.entries();
    const auto run = ground(file, flags);
    EXPECT_EQ(1, run.status) << run.err;
    EXPECT_EQ("", run.out);
    EXPECT_TRUE(isOneError(run.err)) << run.err;
    for (const auto& word : words)
      EXPECT_TRUE(contains(run.err, word)) << word << " in: " << run.err;
    EXPECT_EQ(before, m_dir.entries());
  }

  Raster raster() const { return readRaster(path("out/ground.tif")); }
  static const Raster::Band& bandOf(const Raster& raster, const std::string& name)
  {
    return *std::find_if(raster.bands.begin(), raster.bands.end(),
                         [&](const Raster::Band& band) { return band.name == name; });
  }
  static const Raster::Band& bandOf(Raster&& raster, const std::string& name) = delete;
  /** Of the map that was written. */
  Raster::Band band(const std::string& name) const
  {
    const Raster map = raster();
    return bandOf(map, name);
  }
  std::vector<double> cellsOf(const std::string& name) const { return band(name).cells; }

  TempDir m_dir;
};

}  // namespace mrpt_mapconv::testing
