#include <mrpt_mapconv/files/FileIo.h>

#include "support/TempDir.h"

using namespace mrpt_mapconv::files;
using namespace mrpt_mapconv::testing;

TEST(FileIo, writesAndReplaces)
{
  const TempDir dir;
  writeFile(dir.path("a"), "a longer text");
  writeFile(dir.path("a"), std::string("\0short", 6));
  EXPECT_EQ(readBytes(dir.path("a")), std::string("\0short", 6));
  EXPECT_NO_THROW(checkWritten(dir.path("a")));
}

TEST(FileIo, errorsNameFileAndReason)
{
  const TempDir dir;
  const auto missing = messageOf([&] { writeFile(dir.path("no/file"), "x"); });
  EXPECT_EQ(missing, "cannot write '" + dir.path("no/file") + "': No such file or directory");
  const auto folder = messageOf([&] { writeFile(dir.path(), "x"); });
  EXPECT_TRUE(contains(folder, "Is a directory")) << folder;
  EXPECT_THROW(checkWritten(dir.path("none")), std::runtime_error);
}

TEST(FileIo, theEndingPassesOverThatOfGzip)
{
  EXPECT_EQ(".bt", endingOf("folder.d/map.BT.gz"));
  EXPECT_EQ(".ot", endingOf("map.ot"));
  EXPECT_EQ("", endingOf("a.b/map"));
}

TEST(FileIo, noticesFullDisk)
{
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto message = messageOf([] { writeFile("/dev/full", "x"); });
  EXPECT_EQ(message, "cannot write '/dev/full': No space left on device");
}

TEST(FileIo, TheReasonWhyAnotherLibraryFailedIsAskedForWithoutMakingRoom)
{
  const TinyDisk disk(256);
  if (!disk.mounted()) GTEST_SKIP() << "no right to mount a small disk";
  const auto reasonAt = [&](const std::string& name)
  { return messageOf([&] { throwUnwritten(disk.path(name), "the picture is incomplete"); }); };
  EXPECT_THROW(writeFile(disk.path("a"), std::string(1U << 20U, 'x')), std::runtime_error);
  EXPECT_EQ(reasonAt("a"), "cannot write '" + disk.path("a") + "': No space left on device");
  std::filesystem::remove(disk.path("a"));  // as OpenCV does with what it cannot write
  EXPECT_TRUE(contains(reasonAt("a"), "No space left on device")) << reasonAt("a");
  const TempDir roomy;
  writeFile(roomy.path("a"), "short");
  EXPECT_EQ(messageOf([&] { throwUnwritten(roomy.path("a"), "it is no PNG"); }),
            "cannot write '" + roomy.path("a") + "': it is no PNG");
}
