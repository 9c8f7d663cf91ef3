#include <mrpt_mapconv/files/AtomicFile.h>
#include <mrpt_mapconv/files/FileIo.h>

#include "support/TempDir.h"

namespace fs = std::filesystem;
using namespace mrpt_mapconv::files;
using namespace mrpt_mapconv::testing;

TEST(AtomicFile, replacesAtCommit)
{
  const TempDir dir;
  writeFile(dir.path("x.csv"), "old");
  AtomicFile file(dir.path("x.csv"));
  EXPECT_EQ(fs::path(file.stagingPath()).filename(), "x.csv");
  writeFile(file.stagingPath(), "new");
  EXPECT_EQ(readBytes(dir.path("x.csv")), "old");
  file.commit();
  EXPECT_EQ(readBytes(dir.path("x.csv")), "new");
  EXPECT_EQ(dir.entries(), 1U);
}

TEST(AtomicFile, leavesNothingWithoutCommit)
{
  const TempDir dir;
  {
    const AtomicFile file(dir.path("sub/x"));
    writeFile(file.stagingPath(), "new");
  }
  EXPECT_EQ(dir.entries(), 0U);
}

TEST(AtomicFile, followsLinks)
{
  const TempDir dir;
  fs::create_directory(dir.path("real"));
  writeFile(dir.path("real/x"), "old");
  fs::create_symlink(dir.path("real/x"), dir.path("link"));
  AtomicFile file(dir.path("link"));
  writeFile(file.stagingPath(), "new");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(dir.path("link")));
  EXPECT_EQ(readBytes(dir.path("real/x")), "new");
}

TEST(AtomicFile, writesDevicesDirectly)
{
  AtomicFile file("/dev/null");
  EXPECT_EQ(file.stagingPath(), "/dev/null");
  writeFile(file.stagingPath(), "x");
  file.commit();
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(AtomicFile, refusesFoldersAndPathsUnderFiles)
{
  const TempDir dir;
  writeFile(dir.path("file"), "");
  EXPECT_TRUE(contains(messageOf([&] { AtomicFile(dir.path()); }), "Is a directory"));
  EXPECT_TRUE(contains(messageOf([&] { AtomicFile(dir.path("file/x")); }), "Not a directory"));
  EXPECT_TRUE(contains(messageOf([] { AtomicFile("/proc/x/y"); }), "/proc/x"));
}
