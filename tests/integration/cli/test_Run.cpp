#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "Program.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

TEST(Run, givesTheProgramsOwnStatus)
{
  EXPECT_EQ(0, mapconv({"run", "--", "true"}).status);
  EXPECT_EQ(7, mapconv({"run", "--", "sh", "-c", "exit 7"}).status);
  EXPECT_EQ(128 + 9, mapconv({"run", "--", "sh", "-c", "kill -9 $$"}).status);
}

TEST(Run, passesEveryArgumentAsItIs)
{
  const auto run = mapconv(
      {"run", "--", "printf", "<%s>", "--help", "", "--", "[a,b]", "a b", "--version", "-o"});
  EXPECT_EQ(0, run.status) << run.err;
  EXPECT_EQ("<--help><><--><[a,b]><a b><--version><-o>", run.out);
  EXPECT_EQ("hi\n", mapconv({"run", "echo", "hi"}).out);
}

TEST(Run, preloadsTheLibraryInFrontOfOthers)
{
  const std::string library = std::filesystem::canonical(MRPT_MAPCONV_LIBRARY).string();
  ::unsetenv("LD_PRELOAD");
  EXPECT_EQ(library,
            mapconv({"run", "--", "printenv", "LD_PRELOAD"}).out.substr(0, library.size()));
  // any library will do that is there
  ::setenv("LD_PRELOAD", library.c_str(), 1);
  const auto run = mapconv({"run", "--", "printenv", "LD_PRELOAD"});
  ::unsetenv("LD_PRELOAD");
  EXPECT_EQ(library + ":" + library + "\n", run.out);
}

TEST(Run, theLibraryIsReallyLoaded)
{
  const auto run = mapconv({"run", "--", "cat", "/proc/self/maps"});
  EXPECT_TRUE(contains(run.out, "libmrpt_mapconv.so"));
}

TEST(Run, aProgramThatIsNotThereIsNamed)
{
  const auto run = mapconv({"run", "--", "no-such-program-here"});
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "no-such-program-here")) << run.err;
}

TEST(Run, warnsOfMapsThatMrptWouldIgnoreSilently)
{
  const TempDir dir;
  std::ofstream(dir.path("typo.ini")) << "[MappingApplication]\nfreeSpaceGird_count = 1\n"
                                      << "[MappingApplication_freeSpaceGird_00_insertOpts]\n"
                                      << "[PF]\nsample_count = 5\n";
  const auto typo = mapconv({"run", "--", "true", dir.path("typo.ini")});
  EXPECT_EQ(0, typo.status);
  EXPECT_TRUE(contains(typo.err, "mapconv: warning: ")) << typo.err;
  EXPECT_TRUE(contains(typo.err, "freeSpaceGird_count")) << typo.err;
  EXPECT_FALSE(contains(typo.err, "sample_count")) << typo.err;

  const std::string good =
      std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/freeSpaceGrid/observations2map.ini";
  EXPECT_EQ("", mapconv({"run", "--", "true", good}).err);
}

TEST(Run, knowsBothMapsOfThisLibrary)
{
  const TempDir dir;
  std::ofstream(dir.path("both.ini"))
      << "[MappingApplication]\nfreeSpaceGrid_count = 1\nscanShapeGrid_count = 1\n"
      << "[MappingApplication_scanShapeGrid_00_insertOpts]\nreflectionFilter = false\n"
      << "[Other]\nscanShapeGird_count = 1\n[Other_scanShapeGird_00_insertOpts]\n";
  const auto run = mapconv({"run", "--", "true", dir.path("both.ini")});
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "scanShapeGird_count")) << run.err;
}

TEST(Run, worksFromAFolderWithASpaceInItsName)
{
  const TempDir dir;
  const std::filesystem::path place(dir.path("a b"));
  std::filesystem::create_directories(place / "bin");
  std::filesystem::create_directories(place / "lib");
  const auto library = std::filesystem::canonical(MRPT_MAPCONV_LIBRARY);
  std::filesystem::copy(library, place / "lib" / library.filename());
  const std::string shell = "LD_LIBRARY_PATH='" + (place / "lib").string() + "' LD_PRELOAD='" +
                            library.filename().string() +
                            "' exec '" MAPCONV_PROGRAM
                            "' run -- printenv LD_PRELOAD LD_LIBRARY_PATH";
  const auto run = runProgram({"sh", "-c", shell});
  EXPECT_EQ(0, run.status) << run.err;
  // the shell above sets both once, as the only way to run from there; ours stand in front of them
  const std::string name = library.filename().string(), folder = (place / "lib").string();
  EXPECT_EQ(name + ":" + name + "\n" + folder + ":" + folder + "\n", run.out);
}
