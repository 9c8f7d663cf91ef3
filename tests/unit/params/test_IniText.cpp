#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/params/IniText.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "support/TempDir.h"

using mrpt_mapconv::params::readIniText;
using mrpt_mapconv::testing::TempDir;

namespace
{
std::string failure(const std::string& path)
{
  try
  {
    readIniText(path);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}
}  // namespace

TEST(IniText, ComesBackAsItIs)
{
  const TempDir dir;
  const std::string text =
      "; a comment\n# another\n// a third\n\n[section]\n @define X 1\nkey = a \\\n b c\n  k=\r\n";
  std::ofstream(dir.path("a.ini")) << text;
  EXPECT_EQ(text, readIniText(dir.path("a.ini")));
}

TEST(IniText, AByteOrderMarkAndWindowsLineEndsAreNoPartOfIt)
{
  const TempDir dir;
  const std::string path = dir.path("bom.ini");
  std::ofstream(path) << "\xEF\xBB\xBF[conversion]\r\nminClearance = 0.5\r\n";
  const mrpt::config::CConfigFileMemory ini(readIniText(path));
  mrpt_mapconv::params::StrictSection section(ini, "conversion");
  double value = 0;
  section.read("minClearance", value);
  EXPECT_EQ(0.5, value);
}

TEST(IniText, LinesWithoutMeaningAreNamed)
{
  const TempDir dir;
  const std::string path = dir.path("a.ini");
  std::ofstream(path) << "[section]\nkey = 1\nforgotten 2\n";
  EXPECT_EQ(path + ": line 3: 'forgotten 2' is no section, comment or key = value", failure(path));
  std::ofstream(path) << "= 2\n";
  EXPECT_NE(std::string::npos, failure(path).find("line 1"));
  EXPECT_NE(std::string::npos, failure(dir.path("none.ini")).find("cannot be opened"));
  EXPECT_NE(std::string::npos, failure(dir.path()).find("is a folder"));
}

// MRPT would give the second value, and of two sections the keys of both mixed.
TEST(IniText, WhatIsThereTwiceIsNamed)
{
  const TempDir dir;
  const std::string path = dir.path("a.ini");
  const auto failureOf = [&](const std::string& text)
  {
    std::ofstream(path) << text;
    return failure(path);
  };
  EXPECT_EQ(failureOf("[box.wall]\nmin = 1\n\n[box.roof]\nmin = 2\n[box.wall]\nmin = 3\n"),
            path + ": line 6: section 'box.wall' is already in line 1; it must be there only once");
  EXPECT_EQ(failureOf("# a\n[box.wall]\nmin = 1\nmax = 2\n  min=3\n"),
            path +
                ": line 5: section 'box.wall': key 'min' is already in line 3; it must be there "
                "only once");
  EXPECT_EQ(failureOf("[Box.wall] ; first\n[ box.WALL ]\n"),
            path + ": line 2: section 'box.WALL' is already in line 1; it must be there only once");
  EXPECT_EQ(failureOf("[a]\nmax = 1 \\\n 2\nMax = 3\n"),
            path +
                ": line 4: section 'a': key 'Max' is already in line 2; it must be there only "
                "once");
}

TEST(IniText, WhatOnlyLooksLikeTwiceIsRead)
{
  const TempDir dir;
  const std::string path = dir.path("a.ini");
  const std::string text =
      "[a]\nx = 1\n[b]\nx = 2\n# x = 3\n; x = 4\n// x = 5\ny = 6 \\\n x = 7\n[a.b]\nx = 8\n";
  std::ofstream(path) << text;
  EXPECT_EQ(text, readIniText(path));
}

TEST(IniText, TheRepositorysOwnFilesAreGood)
{
  const std::filesystem::path config = MRPT_MAPCONV_SOURCE_DIR "/config";
  std::size_t files = 0;
  for (const auto& folder : {config / "worlds", config / "experiments", config / "freeSpaceGrid",
                             config / "scanShapeGrid"})
    for (const auto& file : std::filesystem::directory_iterator(folder))
    {
      EXPECT_EQ("", failure(file.path().string()));
      ++files;
    }
  EXPECT_EQ("", failure((config / "freeSpaceGrid/convert.ini").string()));
  EXPECT_GE(files, 5u);
}
