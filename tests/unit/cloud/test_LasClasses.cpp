#include <gtest/gtest.h>
#include <mrpt_mapconv/cloud/LasClasses.h>

#include "CloudBytes.h"
#include "LasBytes.h"

using namespace mrpt_mapconv::cloud;
using namespace mrpt_mapconv::testing;

namespace
{
/** Three points whose bytes all differ, records before and behind them; the second is withheld. */
LasBytes threePoints(int format)
{
  LasBytes las;
  las.format = format;
  las.minor = 4;
  las.pointSize = static_cast<std::uint16_t>(LasBytes::sizeOf(format) + 3);
  las.record("someone", 7, "before");
  las.lateRecord("someone", 8, "behind");
  for (int i = 0; i < 3; ++i)
  {
    las.add(i, 10 * i, 100 * i);
    for (std::size_t at = 12; at < las.size(); ++at)
      las.set(at, static_cast<std::uint8_t>(at + 50 * static_cast<std::size_t>(i)));
    const unsigned withheld = i == 1 ? (format < 6 ? 0x80 : 0x04) : 0;
    las.set(15, static_cast<std::uint8_t>((format < 6 ? 0x61U : 0xFBU) | withheld));
  }
  return las;
}

std::string copied(const std::string& bytes, const std::vector<std::uint8_t>& classes)
{
  const TempDir dir;
  std::ofstream(dir.path("a.las"), std::ios::binary) << bytes;
  copyLasWithClasses(dir.path("a.las"), dir.path("b.las"), classes);
  EXPECT_EQ(2U, dir.entries());
  return readBytes(dir.path("b.las"));
}
}  // namespace

TEST(LasClasses, ACopyDiffersInTheClassOnlyAndNotInThatOfWithheldPoints)
{
  for (int format = 0; format < 11; ++format)
  {
    const LasBytes las = threePoints(format);
    std::string expected = las.bytes();
    const std::size_t first = 375 + las.records.size(), third = first + 2U * las.size();
    if (format < 6)
    {
      putAt(expected, first + 15, std::uint8_t(0x60 | 2));
      putAt(expected, third + 15, std::uint8_t(0x60 | 31));
    }
    else
    {
      putAt(expected, first + 16, std::uint8_t(2));
      putAt(expected, third + 16, std::uint8_t(31));
    }
    EXPECT_EQ(expected, copied(las.bytes(), {2, 5, 31})) << format;
  }
}

TEST(LasClasses, ClassesThatDoNotFitAreRefusedAndNothingIsWritten)
{
  const TempDir dir;
  std::ofstream(dir.path("a.las"), std::ios::binary) << threePoints(3).bytes();
  const auto message = [&](const std::vector<std::uint8_t>& classes)
  { return messageOf([&] { copyLasWithClasses(dir.path("a.las"), dir.path("b.las"), classes); }); };
  EXPECT_TRUE(contains(message({1, 2}), "a.las: has 3 points for 2 classes"));
  EXPECT_TRUE(contains(message({1, 2, 32}), "classes of 0 to 31, not 32"));
  EXPECT_EQ(1U, dir.entries());
}

TEST(LasClasses, ATruncatedFileLeavesNoCopy)
{
  const TempDir dir;
  const std::string bytes = threePoints(0).bytes();
  std::ofstream(dir.path("a.las"), std::ios::binary) << bytes.substr(0, bytes.size() - 80);
  EXPECT_TRUE(contains(messageOf(
                           [&] {
                             copyLasWithClasses(dir.path("a.las"), dir.path("b.las"), {1, 1, 1});
                           }),
                       "is truncated"));
  EXPECT_EQ(1U, dir.entries());
}

TEST(LasClasses, TheCopyMayTakeTheFilesPlace)
{
  const TempDir dir;
  std::ofstream(dir.path("a.las"), std::ios::binary) << threePoints(7).bytes();
  copyLasWithClasses(dir.path("a.las"), dir.path("a.las"), {9, 9, 9});
  EXPECT_EQ(9, readCloudFile(dir.path("a.las")).classification[2]);
}
