// Whether the source tree is as share/doc/architecture.md draws it; and whether who looks at it
// would see if it were not.
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "House.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::house;
namespace fs = std::filesystem;

namespace
{
const fs::path kRoot = MRPT_MAPCONV_SOURCE_DIR;

std::string lines(const Complaints& complaints)
{
  std::string text;
  for (const std::string& complaint : complaints) text += complaint + "\n";
  return text;
}

/** A made-up tree with three rooms, of which nothing is wrong. */
class Tree
{
 public:
  Tree()
  {
    write(Floors::kPage,
          "# The house\n## Rooms of the library, ground floor first\nText.\n\n"
          "| room | holds |\n|---|---|\n| `cellar` | wine |\n| `kitchen` | pots |\n"
          "| `maps` | classes |\n\nTwo more libraries: `sim` and `eval`.\n## Else\n"
          "| `garage` | not a room |\n");
    write(".gitignore", "/build*/\n/demo/\n");
    for (const char* file :
         {"CMakeLists.txt", "README.md", "LICENSE", ".clang-format", "build-x/a", "demo/b",
          "apps/CMakeLists.txt", "config/worlds/a.ini", "config/experiments/b.ini",
          "config/pots/c.ini", "tests/unit/kitchen/test_Pot.cpp", "tests/unit/sim/test_World.cpp",
          "tests/unit/house/test_Rooms.cpp"})
      write(file, "");
    header("cellar", "Wine", "");
    header("kitchen", "Pot", "#include <mrpt_mapconv/cellar/Wine.h>\n");
    header("sim", "World", "#include <mrpt_mapconv/maps/CPots.h>\n");
    write(header("maps", "CPots"), "#include <vector>\nnamespace mrpt_mapconv\n{\n}\n");
    source("cellar/Shelf.h", "namespace mrpt_mapconv::cellar::shelf\n{\n}\n");
    source("kitchen/Pot.cpp",
           "#include <mrpt_mapconv/kitchen/Pot.h>\n#include \"../cellar/Shelf.h\"\n"
           "namespace mrpt_mapconv::kitchen\n{\nnamespace\n{\n}\n}\n");
    source("maps/CPots.cpp",
           "#include <mrpt_mapconv/maps/CPots.h>\n"
           "MAP_DEFINITION_REGISTER(\"mrpt_mapconv::CPots,pots\",\n  mrpt_mapconv::CPots)\n");
    write("apps/mapconv/main.cpp", "#include \"command/Command.h\"\n");
    write("apps/mapconv/command/Command.h", "");
    write("apps/mapconv/command/CookSoup.cpp", "app.add_subcommand(\n  \"cook-soup\", \"Soup\");");
  }

  void write(const fs::path& file, const std::string& text) const
  {
    fs::create_directories((root() / file).parent_path());
    std::ofstream(root() / file) << text;
  }
  void source(const std::string& file, const std::string& text) const
  {
    write("mrpt_mapconv/src/" + file, text);
  }
  static std::string header(const std::string& room, const std::string& name)
  {
    return "mrpt_mapconv/include/mrpt_mapconv/" + room + "/" + name + ".h";
  }
  void header(const std::string& room, const std::string& name, const std::string& includes) const
  {
    write(header(room, name), includes + "namespace mrpt_mapconv::" + room + "\n{\n}\n");
  }

  Complaints complaints() const
  {
    const Floors floors(root());
    Complaints all = complaintsAboutLibrary(root(), floors);
    for (auto& complaint : complaintsAboutFolders(root(), floors)) all.push_back(complaint);
    return all;
  }
  fs::path root() const { return m_dir.path(); }

 private:
  mrpt_mapconv::testing::TempDir m_dir;
};

/** One complaint, which says this. */
void expectOnly(const Tree& tree, const std::string& complaint)
{
  EXPECT_EQ(lines(tree.complaints()), complaint + "\n");
}
}  // namespace

TEST(House, TheLibraryIsAsThePageDrawsIt)
{
  EXPECT_EQ(lines(complaintsAboutLibrary(kRoot, Floors(kRoot))), "");
}

TEST(House, FoldersAreAsThePageDrawsThem)
{
  EXPECT_EQ(lines(complaintsAboutFolders(kRoot, Floors(kRoot))), "");
}

TEST(House, TheLibraryIsLookedAt)
{
  const Floors none(std::vector<std::string>{});
  EXPECT_GT(complaintsAboutLibrary(kRoot, none).size(), 10u);
}

TEST(MadeUpHouse, NothingIsWrongWithIt) { EXPECT_EQ(lines(Tree().complaints()), ""); }

TEST(MadeUpHouse, AnArrowUpIsRefused)
{
  const Tree tree;
  tree.header("cellar", "Wine", "#include <mrpt_mapconv/kitchen/Pot.h>\n");
  expectOnly(
      tree,
      "mrpt_mapconv/include/mrpt_mapconv/cellar/Wine.h: includes mrpt_mapconv/kitchen/Pot.h: "
      "room cellar lies below kitchen");
}

TEST(MadeUpHouse, APrivateArrowUpIsRefused)
{
  const Tree tree;
  tree.source("kitchen/Stove.h", "");
  tree.source("cellar/Shelf.h", "  #  include \"../kitchen/Stove.h\"\n");
  expectOnly(tree,
             "mrpt_mapconv/src/cellar/Shelf.h: includes ../kitchen/Stove.h: room cellar lies below "
             "kitchen");
}

TEST(MadeUpHouse, WhatIsInCommentsIsNoInclude)
{
  const Tree tree;
  tree.source("cellar/Shelf.h", "// #include <mrpt_mapconv/kitchen/Pot.h>\n");
  EXPECT_EQ(lines(tree.complaints()), "");
}

TEST(MadeUpHouse, NoRoomKnowsTheSimulatorNorTheSimulatorEvaluation)
{
  const Tree tree;
  tree.header("eval", "Score", "");
  tree.source("maps/CPots.cpp",
              "#include <mrpt_mapconv/sim/World.h>\nMAP_DEFINITION_REGISTER(\"a::CPots,pots\", a)");
  tree.source("sim/World.cpp", "#include <mrpt_mapconv/eval/Score.h>\n");
  EXPECT_EQ(lines(tree.complaints()),
            "mrpt_mapconv/src/maps/CPots.cpp: includes mrpt_mapconv/sim/World.h: room maps lies "
            "below sim\n"
            "mrpt_mapconv/src/sim/World.cpp: includes mrpt_mapconv/eval/Score.h: room sim lies "
            "below eval\n");
}

TEST(MadeUpHouse, AnUnknownRoomIsRefused)
{
  const Tree tree;
  tree.source("garage/Car.cpp", "namespace mrpt_mapconv::garage\n{\n}\n");
  tree.header("garden", "Tree", "");
  tree.write("tests/unit/garage/test_Car.cpp", "");
  tree.source("kitchen/Pot.cpp", "#include \"../garage/Car.h\"\n");
  tree.source("garage/Car.h", "");
  EXPECT_EQ(lines(tree.complaints()),
            "mrpt_mapconv/include/mrpt_mapconv/garden: is no room that the page lists\n"
            "mrpt_mapconv/src/garage: is no room that the page lists\n"
            "mrpt_mapconv/src/kitchen/Pot.cpp: includes ../garage/Car.h, which is of no room\n"
            "tests/unit/garage: tests of no room\n");
}

TEST(MadeUpHouse, TheLibraryDoesNotIncludeTheProgram)
{
  for (const std::string name : {"command/Command.h", "../../../apps/mapconv/command/Command.h"})
  {
    const Tree tree;
    tree.source("kitchen/Pot.cpp", "#include \"" + name + "\"\n");
    expectOnly(tree, "mrpt_mapconv/src/kitchen/Pot.cpp: includes \"" + name +
                         "\", which is no header beside it or of a room");
  }
}

TEST(MadeUpHouse, ANamespaceIsThatOfItsFolder)
{
  const Tree tree;
  tree.header("maps", "Sections", "");
  tree.source("cellar/Shelf.h", "namespace mrpt_mapconv::kitchen\n{\n}\nnamespace octomap\n{\n}\n");
  tree.source("kitchen/Pot.cpp", "namespace mrpt_mapconv\n{\n}\n");
  tree.source("sim/World.cpp", "namespace mrpt_mapconv::simulator\n{\n}\n");
  EXPECT_EQ(lines(tree.complaints()),
            "mrpt_mapconv/src/cellar/Shelf.h: has namespace mrpt_mapconv::kitchen instead of "
            "mrpt_mapconv::cellar\n"
            "mrpt_mapconv/src/kitchen/Pot.cpp: has namespace mrpt_mapconv instead of "
            "mrpt_mapconv::kitchen\n"
            "mrpt_mapconv/src/sim/World.cpp: has namespace mrpt_mapconv::simulator instead of "
            "mrpt_mapconv::sim\n");
}

TEST(MadeUpHouse, WhatHasNoPlaceIsRefused)
{
  const Tree tree;
  tree.write("notes.txt", "");
  tree.write("apps/other/main.cpp", "");
  tree.write("apps/mapconv/algorithm/Sort.cpp", "");
  tree.write("config/pans/a.ini", "");
  EXPECT_EQ(lines(tree.complaints()),
            "notes.txt: has no place at the top level\n"
            "apps/other: is no program of ours\n"
            "apps/mapconv/algorithm: is none of command, input, output, experiment and main.cpp\n"
            "config/pans: is neither worlds, experiments, a room nor the name of a registered map "
            "class\n");
}

TEST(MadeUpHouse, ATestThatNeedsTheProgramsSourcesIsRefused)
{
  const Tree tree;
  tree.write("tests/CMakeLists.txt", "add_executable(a ${PROJECT_SOURCE_DIR}/apps/mapconv/a.cpp)");
  tree.write("tests/unit/kitchen/test_Pot.cpp", "#include \"../../../apps/mapconv/a.h\"\n");
  EXPECT_EQ(lines(tree.complaints()),
            "tests/CMakeLists.txt: takes sources of apps, whose algorithms belong into the "
            "library\n"
            "tests/unit/kitchen/test_Pot.cpp: takes sources of apps, whose algorithms belong into "
            "the library\n");
}

TEST(MadeUpHouse, ASubcommandHasAFileOfItsName)
{
  const Tree tree;
  tree.write("apps/mapconv/command/CookSoup.cpp",
             "add_subcommand(\"cook-soup\")\nadd_subcommand(\"eat\")\n");
  tree.write("apps/mapconv/command/Helper.cpp", "");
  tree.write("apps/mapconv/input/Wash.cpp", "add_subcommand(\"wash\")\n");
  EXPECT_EQ(lines(tree.complaints()),
            "apps/mapconv/command/CookSoup.cpp: subcommand eat belongs into command/Eat.cpp\n"
            "apps/mapconv/command/Helper.cpp: declares no subcommand\n"
            "apps/mapconv/input/Wash.cpp: subcommand wash belongs into command/Wash.cpp\n");
}

TEST(MadeUpHouse, AnArrowUpInTheProgramIsRefused)
{
  const Tree tree;
  const auto write = [&](const std::string& file, const std::string& include)
  { tree.write("apps/mapconv/" + file, "#include \"" + include + "\"\n"); };
  write("experiment/taste/Taste.cpp", "input/Wash.h");
  write("experiment/Taste.h", "command/Command.h");
  write("input/Wash.h", "output/Json.h");
  write("input/Wash.cpp", "output/Dish.h");
  write("output/Dish.h", "input/Wash.h");
  write("output/Dish.cpp", "../input/Wash.h");
  EXPECT_EQ(lines(tree.complaints()),
            "apps/mapconv/experiment/Taste.h: includes command/Command.h: experiment lies below "
            "command\n"
            "apps/mapconv/input/Wash.cpp: includes output/Dish.h: input uses Console, Json and "
            "Progress only\n"
            "apps/mapconv/output/Dish.cpp: includes ../input/Wash.h: it is in no folder of the "
            "program\n"
            "apps/mapconv/output/Dish.h: includes input/Wash.h: output lies below input\n");
}

TEST(MadeUpHouse, APageWithoutAFullTableIsRefused)
{
  using mrpt_mapconv::testing::messageOf;
  const std::string heading = "## Rooms of the library\n", rows = "| `a` | x |\n| `b` | y |\n";
  const Tree tree;
  const auto problem = [&](const std::string& page)
  {
    tree.write(Floors::kPage, page);
    return messageOf([&] { Floors floors(tree.root()); });
  };
  EXPECT_EQ(
      problem("## Something else\n" + rows),
      "share/doc/architecture.md: no table of rooms below a heading \"Rooms of the library\"");
  EXPECT_EQ(problem(heading + rows + "\nNames `sim` only.\n"),
            "share/doc/architecture.md: no `eval` after the table of rooms");
  EXPECT_EQ(problem(heading + "`sim` and `eval` before\n" + rows),
            "share/doc/architecture.md: no `sim` after the table of rooms");
  EXPECT_EQ(problem(heading + rows + rows + "\n`sim`, `eval`\n"),
            "share/doc/architecture.md: a room stands twice in the table");
  fs::remove(tree.root() / Floors::kPage);
  EXPECT_THROW(Floors floors(tree.root()), std::runtime_error);
}
