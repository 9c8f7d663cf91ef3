#include <gtest/gtest.h>
#include <mrpt_mapconv/maps/IniText.h>

#include <fstream>
#include <stdexcept>

#include "../grid/TempDir.h"

using mrpt_mapconv::maps::readIniText;
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
