#include <gtest/gtest.h>

#include <algorithm>

#include "CloudBytes.h"

using namespace mrpt_mapconv::cloud;
using namespace mrpt_mapconv::testing;

namespace
{
std::string header(const std::string& format, const std::string& elements)
{
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nobj_info nothing\n" + elements +
         "end_header\n";
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
std::string vertices(std::size_t count, const std::string& properties = kXyz)
{
  return "element vertex " + std::to_string(count) + "\n" + properties;
}

/** The bytes of a number, the most significant first. */
template <class Number>
std::string bigEndian(Number number)
{
  std::string bytes = bytesOf(number);
  std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

const std::string kMixed =
    "property uchar red\nproperty double z\nproperty list uchar int neighbours\n"
    "property int x\nproperty short y\nproperty float64 scalar_GpsTime\n"
    "property uint8 Classification\nproperty ushort Intensity\nproperty char extra\n";

void expectMixed(const PointCloud& cloud)
{
  EXPECT_EQ((std::vector<double>{-70000, 4}), cloud.x);
  EXPECT_EQ((std::vector<double>{-2, 5}), cloud.y);
  EXPECT_EQ((std::vector<double>{0.1, 6}), cloud.z);
  EXPECT_EQ((std::vector<double>{99.25, 100}), cloud.time);
  EXPECT_EQ((std::vector<std::uint8_t>{2, 200}), cloud.classification);
  EXPECT_EQ((std::vector<float>{60000, 7}), cloud.intensity);
  EXPECT_EQ((std::vector<std::string>{"red", "neighbours", "extra"}), cloud.otherFields);
}

const CloudReading kAsItIs{mrpt::math::TPoint3D(0, 0, 0), ""};
}  // namespace

TEST(Ply, AsciiVerticesArePoints)
{
  const PointCloud cloud =
      readBytesAs("a.ply", header("ascii", vertices(2)) + "1 2 3\r\n-1e1 +2.5 nan\n");
  EXPECT_EQ((std::vector<double>{1}), cloud.x);
  EXPECT_EQ(1U, cloud.notFinite);
  EXPECT_EQ("PLY, ascii", cloud.format);
}

TEST(Ply, BinaryVerticesComeInEitherByteOrder)
{
  const PointCloud little = readBytesAs("a.ply", header("binary_little_endian", vertices(1)) +
                                                     bytesOf(1.5F) + bytesOf(2.F) + bytesOf(3.F));
  EXPECT_EQ(1.5, little.x[0]);
  EXPECT_EQ(3, little.z[0]);
  EXPECT_EQ("PLY, binary, little endian", little.format);
  const PointCloud big =
      readBytesAs("a.ply", header("binary_big_endian", vertices(1)) + bigEndian(1.5F) +
                               bigEndian(2.F) + bigEndian(3.F));
  EXPECT_EQ(1.5, big.x[0]);
  EXPECT_EQ(3, big.z[0]);
  EXPECT_EQ("PLY, binary, big endian", big.format);
}

TEST(Ply, PropertiesComeInAnyOrderAndTypeAndListsAreReadOver)
{
  expectMixed(readBytesAs("a.ply",
                          header("ascii", vertices(2, kMixed)) +
                              "9 0.1 2 11 12 -70000 -2 99.25 2 60000 -1\n"
                              "9 6 0 4 5 100 200 7 -1\n",
                          kAsItIs));
  const auto bytes = [](const auto& number)
  {
    std::string first = number(std::uint8_t(9)) + number(0.1) + number(std::uint8_t(2)) +
                        number(std::int32_t(11)) + number(std::int32_t(12)) +
                        number(std::int32_t(-70000)) + number(std::int16_t(-2)) + number(99.25) +
                        number(std::uint8_t(2)) + number(std::uint16_t(60000)) +
                        number(std::int8_t(-1));
    return first + number(std::uint8_t(9)) + number(6.0) + number(std::uint8_t(0)) +
           number(std::int32_t(4)) + number(std::int16_t(5)) + number(100.0) +
           number(std::uint8_t(200)) + number(std::uint16_t(7)) + number(std::int8_t(-1));
  };
  expectMixed(readBytesAs("a.ply",
                          header("binary_little_endian", vertices(2, kMixed)) +
                              bytes([](auto number) { return bytesOf(number); }),
                          kAsItIs));
  expectMixed(readBytesAs("a.ply",
                          header("binary_big_endian", vertices(2, kMixed)) +
                              bytes([](auto number) { return bigEndian(number); }),
                          kAsItIs));
}

TEST(Ply, ElementsBeforeAndBehindTheVerticesAreReadOver)
{
  const std::string before =
                        "element camera 2\nproperty int a\nproperty list int float b\n"
                        "element nothing 5\nelement pair 1\nproperty int a\nproperty int b\n",
                    behind = "element face 1\nproperty list uchar int vertex_indices\n";
  const auto ascii =
      header("ascii", before + vertices(1) + behind) + "1 2 0.5 0.5\n2 0\n7 8\n1 2 3\n3 0 0 0\n";
  EXPECT_EQ(3, readBytesAs("a.ply", ascii).z[0]);
  const std::string camera = bytesOf(1) + bytesOf(2) + bytesOf(0.5F) + bytesOf(0.5F) + bytesOf(2) +
                             bytesOf(0) + bytesOf(7) + bytesOf(8);
  EXPECT_EQ(3, readBytesAs("a.ply", header("binary_little_endian", before + vertices(1) + behind) +
                                        camera + bytesOf(1.F) + bytesOf(2.F) + bytesOf(3.F))
                   .z[0]);
}

TEST(Ply, TruncatedAndLyingFilesAreRefused)
{
  const std::string point = bytesOf(1.F) + bytesOf(2.F) + bytesOf(3.F);
  expectRefused("a.ply", header("ascii", vertices(2)) + "1 2 3\n", "of which the file has 1");
  expectRefused("a.ply", header("binary_little_endian", vertices(2)) + point + "abc",
                "promises 2 points, of which the file has 1");
  expectRefused(
      "a.ply",
      header("binary_little_endian", "element vertex 18446744073709551615\n" + kXyz) + point,
      "of which the file has 1");
  const std::string list = "property list uint double b\n";
  expectRefused("a.ply",
                header("binary_little_endian", vertices(1, kXyz + list)) + point +
                    bytesOf(std::uint32_t(4000000000U)),
                "of which the file has 0");
  expectRefused("a.ply",
                header("binary_little_endian", vertices(1, kXyz + "property list char int b\n")) +
                    point + bytesOf(std::int8_t(-1)),
                "of which the file has 0");
  expectRefused("a.ply",
                header("binary_little_endian",
                       "element a 18446744073709551615\nproperty int a\n" + vertices(1)) +
                    point,
                "is truncated within its elements a");
  expectRefused("a.ply", header("ascii", vertices(0)), "holds no point");
}

TEST(Ply, BrokenHeadersAreNamedByLine)
{
  expectRefused("a.ply", "ply\nformat ascii 1.0\n" + vertices(1), "no line end_header");
  expectRefused("a.ply", header("text", vertices(1)), "line 2: 'text' is no format of PLY");
  expectRefused("a.ply", "ply\n" + vertices(1) + "end_header\n1 2 3\n", "no line format");
  expectRefused("a.ply", header("ascii", ""), "no element vertex");
  expectRefused("a.ply", header("ascii", "element vertex -1\n"), "line 5: must be 'element'");
  expectRefused("a.ply", header("ascii", "property int x\n"), "before the first element");
  expectRefused("a.ply", header("ascii", vertices(1, "property half x\n")),
                "line 6: 'half' is no type of PLY");
  expectRefused("a.ply", header("ascii", vertices(1, "property list int x\n")),
                "must be 'property', a type and a name");
  expectRefused("a.ply", header("ascii", vertices(1, "property int x\nproperty int y\n")) + "1 2\n",
                "not all of the coordinates");
}

TEST(Ply, BrokenLinesAreNamedByNumber)
{
  expectRefused("a.ply", header("ascii", vertices(1)) + "1 2 z\n", "line 10: 'z' in column 3");
  const std::string listed = header("ascii", vertices(1, "property list int int l\n" + kXyz));
  expectRefused("a.ply", listed + "5 1 2 3\n", "line 11: has a list with fewer numbers");
  expectRefused("a.ply", listed + "1 2 3 4\n", "line 11: has too few numbers");
  expectRefused("a.ply", listed + "1 2 3 4 5 6\n", "line 11: has not as many numbers");
  expectRefused("a.ply", listed + "-1 2 3 4\n", "line 11: has a list");
}
