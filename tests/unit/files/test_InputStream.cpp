#include <fcntl.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/files/InputStream.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

#include "support/Gzip.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::files;
using namespace mrpt_mapconv::testing;

namespace
{
constexpr std::size_t kAll = std::size_t(1) << 30U;

std::string gzipped(const std::string& bytes)
{
  const TempDir dir;
  writeGzipped(dir.path("x"), bytes);
  return readBytes(dir.path("x"));
}

std::string readAll(const std::string& path) { return InputStream(path).readUpTo(kAll); }

/** Longer than a preview and than a buffer of a pipe, and hard to pack. */
std::string longText()
{
  std::string text;
  for (unsigned i = 0, x = 1; i < 300000; ++i) text += static_cast<char>((x = x * 69069 + 1) >> 24);
  return text;
}
}  // namespace

TEST(InputStream, ReadsPlainAndGzippedFilesWhateverTheirName)
{
  const TempDir dir;
  for (const std::string& text : {std::string("short"), longText()})
  {
    writeFile(dir.path("plain.gz"), text);
    writeFile(dir.path("packed.bt"), gzipped(text));
    writeFile(dir.path("two members"), gzipped(text) + gzipped(text));
    EXPECT_EQ(text, readAll(dir.path("plain.gz")));
    EXPECT_EQ(text, readAll(dir.path("packed.bt")));
    EXPECT_EQ(text + text, readAll(dir.path("two members")));
  }
}

TEST(InputStream, ThePreviewTakesNothingAway)
{
  const TempDir dir;
  const std::string text = longText();
  writeFile(dir.path("x"), gzipped(text));
  InputStream stream(dir.path("x"));
  EXPECT_EQ(text.substr(0, InputStream::kPreview), stream.preview());
  EXPECT_FALSE(stream.atEnd());
  EXPECT_EQ(text.substr(0, 10), stream.readUpTo(10));
  EXPECT_EQ(text.substr(10), stream.readUpTo(kAll));
  EXPECT_TRUE(stream.atEnd());
}

TEST(InputStream, APipeIsReadOnceAndHasNoSize)
{
  const TempDir dir;
  const std::string text = longText();
  for (const std::string& bytes : {text, gzipped(text)})
  {
    const std::string pipe = dir.path("pipe" + std::to_string(bytes.size()));
    ASSERT_EQ(0, ::mkfifo(pipe.c_str(), 0600));
    std::thread writer([&] { writeFile(pipe, bytes); });
    InputStream stream(pipe);
    EXPECT_FALSE(stream.fileSize());
    EXPECT_EQ(text.substr(0, 100), stream.preview().substr(0, 100));
    EXPECT_EQ(text, stream.readUpTo(kAll));
    writer.join();
  }
}

TEST(InputStream, ReadsNoMoreThanIsWanted)
{
  const TempDir dir;
  writeFile(dir.path("bomb"), gzipped(std::string(10 << 20U, '\0')));
  InputStream stream(dir.path("bomb"));
  EXPECT_EQ(5000U, stream.readUpTo(5000).size());
}

TEST(InputStream, EveryTruncationAndEveryWrongByteOfGzipIsNoticed)
{
  const TempDir dir;
  const std::string whole = gzipped("a text of a map, a text of a map, a text of a map");
  for (std::size_t n = 3; n < whole.size(); ++n)
  {
    writeFile(dir.path("cut"), whole.substr(0, n));
    const auto message = messageOf([&] { readAll(dir.path("cut")); });
    EXPECT_EQ(0U, message.find(dir.path("cut") + ": is truncated or damaged: unpacking (gzip)"))
        << n << ": " << message;
    EXPECT_FALSE(contains(message, "<fd:")) << message;
  }
  for (std::size_t i = 10; i < whole.size(); ++i)
  {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    writeFile(dir.path("bad"), damaged);
    EXPECT_THROW(readAll(dir.path("bad")), std::runtime_error) << i;
  }
}

TEST(InputStream, SaysWhatCannotBeRead)
{
  const TempDir dir;
  writeFile(dir.path("empty"), "");
  const auto errorOf = [](const std::string& path)
  { return messageOf([&] { InputStream s(path); }); };
  EXPECT_EQ(dir.path("none") + ": no such file", errorOf(dir.path("none")));
  EXPECT_EQ(dir.path() + ": is a directory, not a file", errorOf(dir.path()));
  EXPECT_EQ(dir.path("empty") + ": is empty", errorOf(dir.path("empty")));
  EXPECT_EQ(dir.path("empty/x") + ": cannot be opened for reading: Not a directory",
            errorOf(dir.path("empty/x")));
}
