#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/files/OutputDir.h>

#include "support/TempDir.h"

namespace fs = std::filesystem;
using namespace mrpt_mapconv::files;
using namespace mrpt_mapconv::testing;

TEST(OutputDir, filesAppearAtCommit)
{
  const TempDir dir;
  OutputDir out(dir.path("a/b"));
  writeFile(out.path("one.txt"), "1");
  writeFile(out.path("two.txt"), "2");
  EXPECT_FALSE(fs::exists(dir.path("a/b/one.txt")));
  out.commit();
  EXPECT_EQ(readBytes(dir.path("a/b/one.txt")), "1");
  EXPECT_EQ(readBytes(dir.path("a/b/two.txt")), "2");
  EXPECT_EQ(std::distance(fs::directory_iterator(dir.path("a/b")), {}), 2) << "staging stayed";
}

TEST(OutputDir, keepsWhatWriteAddsBesides)
{
  const TempDir dir;
  OutputDir out(dir.path("out"));
  writeFile(out.path("map.hdr"), "h");
  writeFile(out.path("map.hdr") + ".extra", "e");
  out.commit();
  EXPECT_EQ(readBytes(dir.path("out/map.hdr.extra")), "e");
}

TEST(OutputDir, commitReplacesOlderFiles)
{
  const TempDir dir;
  writeFile(dir.path("x"), "old");
  OutputDir out(dir.path());
  writeFile(out.path("x"), "new");
  EXPECT_EQ(readBytes(dir.path("x")), "old");
  out.commit();
  EXPECT_EQ(readBytes(dir.path("x")), "new");
}

TEST(OutputDir, leavesNothingWithoutCommit)
{
  const TempDir dir;
  {
    OutputDir out(dir.path("a/b"));
    writeFile(out.path("x"), "x");
  }
  EXPECT_EQ(dir.entries(), 0U);
}

TEST(OutputDir, leavesForeignFilesAndFolders)
{
  const TempDir dir;
  fs::create_directory(dir.path("mine"));
  {
    OutputDir mine(dir.path("mine")), fresh(dir.path("fresh"));
    writeFile(dir.path("fresh/other"), "somebody else's");
  }
  EXPECT_TRUE(fs::exists(dir.path("mine")));
  EXPECT_TRUE(fs::exists(dir.path("fresh/other")));
}

TEST(OutputDir, refusesPathsThatCannotBeFolders)
{
  const TempDir dir;
  writeFile(dir.path("file"), "");
  EXPECT_EQ(messageOf([&] { OutputDir out(dir.path("file")); }),
            "cannot create the folder '" + dir.path("file") + "': Not a directory");
  EXPECT_TRUE(contains(messageOf([&] { OutputDir out(dir.path("file/sub")); }), "Not a directory"));
  EXPECT_TRUE(contains(messageOf([] { OutputDir out(""); }), "No such file"));
  EXPECT_TRUE(contains(messageOf([] { OutputDir out("/proc/mapconv"); }), "'/proc/mapconv'"));
  EXPECT_TRUE(contains(messageOf([] { OutputDir out("/proc"); }), "cannot write into '/proc'"));
}

TEST(OutputDir, refusesNamesWithFolders)
{
  const TempDir dir;
  OutputDir out(dir.path());
  for (const char* name : {"", ".", "..", "a/b", "/a"})
    EXPECT_THROW(out.path(name), std::invalid_argument) << name;
}

TEST(OutputDir, commitMissesOutputs)
{
  const TempDir dir;
  OutputDir out(dir.path());
  writeFile(out.path("a"), "a");
  out.path("b");
  const auto message = messageOf([&] { out.commit(); });
  EXPECT_EQ(message, "cannot write '" + dir.path("b") + "': it was never written");
  EXPECT_FALSE(fs::exists(dir.path("a")));
}

TEST(OutputDir, commitDoesNotReplaceFolders)
{
  const TempDir dir;
  fs::create_directory(dir.path("b"));
  OutputDir out(dir.path());
  writeFile(out.path("a"), "a");
  writeFile(out.path("b"), "b");
  EXPECT_TRUE(contains(messageOf([&] { out.commit(); }), "not a regular file"));
  EXPECT_FALSE(fs::exists(dir.path("a")));
}

TEST(OutputDir, MessagesNameTheFinalPath)
{
  EXPECT_EQ(mrpt_mapconv::files::withoutStaging("a/.mapconv-Xy12zQ/floor.png: No space left"),
            "a/floor.png: No space left");
  EXPECT_EQ(mrpt_mapconv::files::withoutStaging("a/.mapconv/floor.png: no"),
            "a/.mapconv/floor.png: no");
}

TEST(OutputDir, SaysWhyAFolderCannotBeCreated)
{
  const mrpt_mapconv::testing::TempDir dir;
  const std::string closed = dir.path("closed");
  ASSERT_EQ(0, ::mkdir(closed.c_str(), 0500));
  if (::geteuid() == 0 && ::seteuid(65534) != 0) GTEST_SKIP() << "cannot drop root's rights";
  ::chmod(dir.path().c_str(), 0755);
  std::string message;
  try
  {
    const mrpt_mapconv::files::OutputDir out(closed + "/x");
  }
  catch (const std::runtime_error& error)
  {
    message = error.what();
  }
  if (::getuid() == 0)
  {
    ASSERT_EQ(0, ::seteuid(0));
  }
  EXPECT_NE(std::string::npos, message.find("Permission denied")) << message;
}
