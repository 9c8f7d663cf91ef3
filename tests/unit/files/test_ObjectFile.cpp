#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt_mapconv/files/ObjectFile.h>

#include "support/ScanFixtures.h"

namespace mrpt_mapconv::files
{
using namespace fixtures;
using mrpt::obs::CObservationComment;

namespace
{
template <class Stream>
void writeComments(const std::string& path, const std::vector<std::string>& texts)
{
  Stream stream(path);
  auto archive = mrpt::serialization::archiveFrom(stream);
  for (const auto& text : texts)
  {
    CObservationComment comment;
    comment.timestamp = mrpt::Clock::fromDouble(1e9);
    comment.text = text;
    archive << comment;
  }
}

std::vector<std::string> readComments(const std::string& path)
{
  ObjectFile file(path);
  std::vector<std::string> texts;
  while (const auto object = file.next())
    texts.push_back(dynamic_cast<CObservationComment&>(*object).text);
  return texts;
}

std::string errorOf(const std::string& path)
{
  return messageOf([&path] { readComments(path); });
}
}  // namespace

TEST(ObjectFile, ReadsGzippedAndPlain)
{
  const TempDir dir;
  const std::vector<std::string> texts{"one", "two", ""};
  writeComments<mrpt::io::CFileGZOutputStream>(dir.file("gz"), texts);
  writeComments<mrpt::io::CFileOutputStream>(dir.file("plain"), texts);
  ASSERT_EQ(readBytes(dir.file("gz")).substr(0, 2), "\x1f\x8b");
  EXPECT_EQ(readComments(dir.file("gz")), texts);
  EXPECT_EQ(readComments(dir.file("plain")), texts);
}

TEST(ObjectFile, EveryTruncationOfACompressedFileIsNoticed)
{
  const TempDir dir;
  const std::string path = dir.file("cut");
  writeComments<mrpt::io::CFileGZOutputStream>(path, {"first", "second", "third"});
  const std::string whole = readBytes(path);
  for (std::size_t n = 1; n < whole.size(); ++n)
  {
    writeBytes(path, whole.substr(0, n));
    EXPECT_TRUE(contains(errorOf(path), path)) << n << " of " << whole.size();
  }
}

TEST(ObjectFile, EveryTruncationOfAPlainFileIsNoticedUnlessBetweenObjects)
{
  const TempDir dir;
  const std::string path = dir.file("cut");
  writeComments<mrpt::io::CFileOutputStream>(path, {"equal", "equal", "equal"});
  const std::string whole = readBytes(path);
  for (std::size_t n = 1; n < whole.size(); ++n)
  {
    writeBytes(path, whole.substr(0, n));
    if (n % (whole.size() / 3) == 0)
      EXPECT_EQ(readComments(path).size(), n / (whole.size() / 3));
    else
      EXPECT_TRUE(contains(errorOf(path), "truncated")) << n << " of " << whole.size();
  }
}

TEST(ObjectFile, SaysThatAnObjectIsCut)
{
  const TempDir dir;
  const std::string path = dir.file("cut");
  writeComments<mrpt::io::CFileOutputStream>(path, {"first", std::string(1000, 'x')});
  const std::string whole = readBytes(path);
  writeBytes(path, whole.substr(0, whole.size() - 500));
  EXPECT_EQ(errorOf(path), path + ": is truncated: it ends in the middle of object 2");
  // MRPT's own reading notices nothing here but a missing end mark.
  writeBytes(path, whole.substr(0, whole.size() - 1));
  EXPECT_EQ(errorOf(path), path + ": is truncated: it ends in the middle of object 2");
}

TEST(ObjectFile, BadFiles)
{
  const TempDir dir;
  EXPECT_EQ(errorOf(dir.file("none")), dir.file("none") + ": no such file");
  EXPECT_EQ(errorOf(dir.path()), dir.path() + ": is a directory, not a file");
  writeBytes(dir.file("empty"), "");
  EXPECT_EQ(errorOf(dir.file("empty")), dir.file("empty") + ": is empty");
  writeBytes(dir.file("text"), "# Octomap OcTree binary file\nid OcTree\n");
  EXPECT_TRUE(contains(errorOf(dir.file("text")), "no file of MRPT objects"));
  writeBytes(dir.file("zeros"), std::string(1000, '\0'));
  EXPECT_TRUE(contains(errorOf(dir.file("zeros")), dir.file("zeros")));
}

TEST(ObjectFile, NamesAnUnknownClass)
{
  const TempDir dir;
  writeBytes(dir.file("a"), std::string("\x87") + "CNewMap" + std::string("\0\x88", 2));
  const std::string error = errorOf(dir.file("a"));
  for (const char* words : {"object 1", "'CNewMap'", "plugin", "LD_PRELOAD", "damaged"})
    EXPECT_TRUE(contains(error, words)) << error;
  writeBytes(dir.file("a"), std::string("\x80\0", 2));
  EXPECT_EQ(errorOf(dir.file("a")),
            dir.file("a") + ": object 1 has no class, so the file is damaged");
}

TEST(ObjectFile, DamageAfterGoodObjects)
{
  const TempDir dir;
  writeComments<mrpt::io::CFileOutputStream>(dir.file("a"), {"good"});
  writeBytes(dir.file("a"), readBytes(dir.file("a")) + std::string(200, '\xff'));
  EXPECT_TRUE(contains(errorOf(dir.file("a")), "object 2")) << errorOf(dir.file("a"));
}

}  // namespace mrpt_mapconv::files
