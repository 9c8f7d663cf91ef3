#include <gtest/gtest.h>
#include <mrpt/config/CConfigFile.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "Program.h"

// `mapconv params` is what share/doc/parameters.md says, and the ini files in config/ say nothing
// else.
namespace
{
using namespace mrpt_mapconv::testing;
namespace fs = std::filesystem;

const fs::path kRoot = MRPT_MAPCONV_SOURCE_DIR;

std::string textOf(const fs::path& path)
{
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string trimmed(const std::string& text)
{
  const auto begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, end + 1 - begin);
}

/** Keys and defaults by section, as "freeSpaceGrid _insertOpts" or "insert [map]". */
using Tables = std::map<std::string, std::map<std::string, std::string>>;

/** The section names between backticks in a heading. */
std::vector<std::string> sectionsIn(const std::string& heading)
{
  std::vector<std::string> names;
  for (std::size_t begin = heading.find('`'); begin != std::string::npos;)
  {
    const auto end = heading.find('`', begin + 1);
    names.push_back(heading.substr(begin + 1, end - begin - 1));
    begin = heading.find('`', end + 1);
  }
  return names;
}

/** Reads the printed tables. */
Tables printedTables()
{
  Tables tables;
  std::istringstream lines(mapconv({"params"}).out);
  std::string map;
  std::vector<std::string> sections;
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("## ", 0) == 0)
      map = line.substr(3, line.find(' ', 3) - 3);
    else if (line.rfind("### ", 0) == 0)
    {
      sections = sectionsIn(line);
      if (line.find("COccupancyGridMap2D's own") != std::string::npos) sections.push_back("grid");
    }
    else if (line.rfind("| `", 0) == 0)
    {
      std::istringstream cells(line.substr(1));
      std::string key, value;
      std::getline(cells, key, '|');
      std::getline(cells, value, '|');
      key = trimmed(key);
      for (const auto& section : sections)
        tables[map + " " + section][key.substr(1, key.size() - 2)] = trimmed(value);
    }
  return tables;
}

/** Keys that are for MRPT's programs only, or whose other name the program's ini file uses. */
bool isLeftOut(const std::string& key, const Tables& tables)
{
  return key == "robot" || key == "objectMaxZ" || tables.at("scanShapeGrid grid").count(key) != 0;
}

struct Value
{
  std::string text, comment;
};

/** The values of a section with their comments, which MRPT does not give; a comment goes on in
 * lines of its own. */
std::map<std::string, Value> valuesIn(const fs::path& path, const std::string& section)
{
  std::map<std::string, Value> values;
  std::ifstream file(path);
  bool inside = false;
  std::string last;
  for (std::string line; std::getline(file, line);)
  {
    if (line.rfind("[", 0) == 0) inside = line == "[" + section + "]";
    const auto equals = line.find('='), comment = line.find("//");
    if (!inside || line.rfind("#", 0) == 0) continue;
    if (equals < comment)
    {
      last = trimmed(line.substr(0, equals));
      values[last].text = trimmed(line.substr(equals + 1, comment - equals - 1));
    }
    if (comment != std::string::npos) values[last].comment += line.substr(comment);
  }
  return values;
}

/** The table's name for a section of an MRPT program; empty if it is none of ours. */
std::string tableOf(const std::string& section)
{
  for (const std::string map : {"freeSpaceGrid", "scanShapeGrid", "terrainGrid"})
    for (const std::string options :
         {"_creationOpts", "_insertOpts", "_conversionOpts", "_terrainOpts", "_renderOpts"})
    {
      const std::string end = "_" + map + "_00" + options;
      if (section.size() > end.size() &&
          section.compare(section.size() - end.size(), end.size(), end) == 0)
        return map + " " + options;
    }
  return "";
}

std::set<std::string> keysOf(const mrpt::config::CConfigFileBase& ini, const std::string& section)
{
  std::vector<std::string> keys;
  ini.getAllKeys(section, keys);
  std::set<std::string> own;
  for (const auto& key : keys)
    if (key.rfind("//", 0) != 0) own.insert(key);
  return own;
}

TEST(Params, ThePageIsWhatIsPrinted)
{
  const auto run = mapconv({"params"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ(textOf(kRoot / "share/doc/parameters.md"), run.out)
      << "make it anew: mapconv params > share/doc/parameters.md";
}

TEST(Params, EveryKeyOfOursInConfigIsInATable)
{
  const Tables tables = printedTables();
  const std::set<std::string> ofAllMaps = {"enableSaveAs3DObject", "enableObservationLikelihood",
                                           "enableObservationInsertion", "robotHeight"};
  std::size_t checked = 0;
  for (const std::string folder : {"freeSpaceGrid", "scanShapeGrid", "terrainGrid"})
    for (const auto& file : fs::directory_iterator(kRoot / "config" / folder))
    {
      const mrpt::config::CConfigFile ini(file.path().string());
      std::vector<std::string> sections;
      ini.getAllSections(sections);
      for (const auto& section : sections)
      {
        const auto table = tables.find(tableOf(section));
        if (table == tables.end()) continue;
        for (const auto& key : keysOf(ini, section))
        {
          ++checked;
          EXPECT_TRUE(table->second.count(key) + ofAllMaps.count(key) > 0)
              << file.path() << ": [" << section << "] " << key;
        }
      }
    }
  EXPECT_GT(checked, 40u);
}

/** convert.ini, insert.ini, terrain.ini and ground.ini say "with their defaults". */
TEST(Params, TheProgramsIniFilesHoldDefaultsOrSayThatTheyDoNot)
{
  const Tables tables = printedTables();
  for (const auto& [path, table, section] : std::vector<std::array<std::string, 3>>{
           {"freeSpaceGrid/convert.ini", "freeSpaceGrid [conversion]", "conversion"},
           {"freeSpaceGrid/convert.ini", "freeSpaceGrid [voxelInsertion]", "voxelInsertion"},
           {"scanShapeGrid/insert.ini", "scanShapeGrid [map]", "map"},
           {"scanShapeGrid/insert.ini", "scanShapeGrid [scanInsertion]", "scanInsertion"},
           {"terrainGrid/terrain.ini", "terrainGrid [map]", "map"},
           {"terrainGrid/terrain.ini", "terrainGrid [terrainInsertion]", "terrainInsertion"},
           {"terrainGrid/terrain.ini", "terrainGrid [terrain]", "terrain"},
           {"aerial/ground.ini", "`mapconv [ground]", "ground"}})
  {
    const auto values = valuesIn(kRoot / "config" / path, section);
    ASSERT_TRUE(tables.count(table) > 0 && !values.empty()) << table;
    for (const auto& [key, right] : tables.at(table))
      EXPECT_TRUE(values.count(key) > 0 || isLeftOut(key, tables))
          << path << ": [" << section << "] lacks " << key;
    for (const auto& [key, value] : values)
    {
      const auto row = tables.at(table).find(key == "robotHeight" ? "objectMaxZ" : key);
      ASSERT_TRUE(row != tables.at(table).end()) << path << ": [" << section << "] " << key;
      const std::string& right = row->second;
      const bool isNumber = right.find_first_not_of("-.0123456789e+") == std::string::npos;
      const bool same = isNumber ? std::stod(value.text) == std::stod(right) : value.text == right;
      EXPECT_TRUE(same || value.comment.find("default") != std::string::npos)
          << path << ": [" << section << "] " << key << " = " << value.text << ", default "
          << right;
    }
  }
}

}  // namespace
