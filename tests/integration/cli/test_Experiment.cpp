#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "Program.h"
#include "unit/grid/TempDir.h"

using namespace mrpt_mapconv::testing;

namespace
{
const std::string kIni = std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/experiments/freespace.ini";

/** Rows of a CSV file without quoted cells. */
std::vector<std::vector<std::string>> rowsOf(const std::string& path)
{
  std::ifstream in(path);
  EXPECT_TRUE(in) << path;
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);)
  {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}
}  // namespace

TEST(Experiment, FreespaceWritesTablesPlotsAndPictures)
{
  const TempDir dir;
  const Outcome outcome = mapconv({"experiment", kIni, "-o", dir.path("out"), "--quick"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_EQ("", outcome.err);
  const std::string report = readBytes(dir.path("out/report.md"));
  EXPECT_EQ(report, outcome.out);
  for (const char* part : {"Table II", "Table III", "paper 2.4", "<= 2", "RMSE", "start–goal"})
    EXPECT_TRUE(contains(report, part)) << part;
  for (const char* name :
       {"updates.png", "updates_by_columns.png", "cave_ground.png", "outdoor_truth.png"})
    EXPECT_EQ("\x89PNG", readBytes(dir.path(std::string("out/") + name)).substr(0, 4)) << name;

  const auto full = rowsOf(dir.path("out/table2_full.csv"));
  ASSERT_EQ(11u, full.size());  // a header, five methods in two worlds
  for (std::size_t i = 1; i < full.size(); ++i) EXPECT_GT(std::stod(full[i].at(2)), 0) << i;
  const auto sizes = rowsOf(dir.path("out/table3_sizes.csv"));
  EXPECT_EQ(7u, sizes.size());
  const auto quality = rowsOf(dir.path("out/quality.csv"));
  ASSERT_EQ(15u, quality.size());
  // what the aerial map of either world calls free is free
  EXPECT_GT(std::stod(quality[1].at(3)), 97) << quality[1].at(0);
  EXPECT_GT(std::stod(quality[8].at(3)), 97) << quality[8].at(0);
  EXPECT_EQ(13u, rowsOf(dir.path("out/paths.csv")).size());
}

TEST(Experiment, BadFilesAreNamed)
{
  const TempDir dir;
  const auto error = [&](const std::string& text)
  {
    std::ofstream(dir.path("e.ini")) << text;
    const Outcome outcome = mapconv({"experiment", dir.path("e.ini"), "-o", dir.path("out")});
    EXPECT_EQ(1, outcome.status);
    EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "e.ini")) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(dir.path("out")));
    return outcome.err;
  };
  EXPECT_TRUE(contains(error(""), "kind"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = cooking\n"), "cooking"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\n"), "worlds"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\nworlds = a\n"), "'a'"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\nworlds = a\npairs = -1\n[a]\n"),
                       "pairs = '-1'"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\nworlds = a\n[a]\nfile = none.ini\n"
                             "paperSizes = 1 2 3\n"),
                       "none.ini"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\nworlds = a\n[a]\nfile = w.ini\n"
                             "paperSizes = 1 2 3\ncolour = red\n"),
                       "colour"));
  const std::string world = "[a]\nfile = w.ini\npaperSizes = 1 2 3\n";
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\nworlds = a a\n" + world), "once"));
  EXPECT_TRUE(contains(
      error("[experiment]\nkind = freespace\nworlds = a\n" + world + "safetyRadius = 0.9\n"),
      "section 'a': safetyRadius = '0.9'"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\nworlds = a\n" + world +
                             "[conversion]\nminClearance = -1\n"),
                       "section 'conversion': minClearance = -1"));
}
