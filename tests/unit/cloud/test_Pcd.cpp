#include <gtest/gtest.h>
#include <liblzf/lzf.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>

#include "CloudBytes.h"

using namespace mrpt_mapconv::cloud;
using namespace mrpt_mapconv::testing;

namespace
{
const float kNan = std::numeric_limits<float>::quiet_NaN();

std::string header(const std::string& fields, const std::string& size, const std::string& count,
                   std::size_t points)
{
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + fields + "\n" + size + "\n" +
         count + "\nWIDTH " + std::to_string(points) +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(points) + "\n";
}

/** Two points x y z of floats. */
std::string twoPoints(const std::string& data)
{
  return header("FIELDS x y z", "SIZE 4 4 4\nTYPE F F F", "COUNT 1 1 1", 2) + "DATA " + data + "\n";
}

std::string floats(const std::vector<float>& values)
{
  std::string bytes;
  for (const float v : values) bytes += bytesOf(v);
  return bytes;
}

/** Its sizes, then the bytes packed. */
std::string packed(const std::string& bytes)
{
  std::string to(bytes.size() + 100, '\0');
  const unsigned size = lzf_compress(bytes.data(), static_cast<unsigned>(bytes.size()), to.data(),
                                     static_cast<unsigned>(to.size()));
  EXPECT_GT(size, 0U);
  to.resize(size);
  return bytesOf(std::uint32_t(size)) + bytesOf(static_cast<std::uint32_t>(bytes.size())) + to;
}
}  // namespace

TEST(Pcd, AsciiLinesArePoints)
{
  const PointCloud cloud = readBytesAs("a.pcd", twoPoints("ascii") + "1 2 3\r\n\n-1.5\t+2e1 .25\n");
  EXPECT_EQ((std::vector<double>{1, -1.5}), cloud.x);
  EXPECT_EQ((std::vector<double>{2, 20}), cloud.y);
  EXPECT_EQ((std::vector<double>{3, 0.25}), cloud.z);
  EXPECT_EQ("PCD, ascii", cloud.format);
  EXPECT_TRUE(cloud.time.empty());
  EXPECT_TRUE(cloud.classification.empty());
}

TEST(Pcd, BinaryPointsFollowOneAnother)
{
  const PointCloud cloud = readBytesAs("a.pcd", twoPoints("binary") + floats({1, 2, 3, 4, 5, 6}));
  EXPECT_EQ((std::vector<double>{1, 4}), cloud.x);
  EXPECT_EQ((std::vector<double>{3, 6}), cloud.z);
  EXPECT_EQ("PCD, binary", cloud.format);
}

TEST(Pcd, CompressedPointsAreFieldByField)
{
  const std::size_t n = 200;
  std::vector<float> values;
  for (std::size_t i = 0; i < 3 * n; ++i) values.push_back(static_cast<float>(i / 4));
  const PointCloud cloud =
      readBytesAs("a.pcd", header("FIELDS x y z", "SIZE 4 4 4\nTYPE F F F", "COUNT 1 1 1", n) +
                               "DATA binary_compressed\n" + packed(floats(values)));
  ASSERT_EQ(n, cloud.size());
  for (std::size_t i = 0; i < n; ++i)
  {
    EXPECT_EQ(static_cast<double>(values[i]), cloud.x[i]);
    EXPECT_EQ(static_cast<double>(values[n + i]), cloud.y[i]);
    EXPECT_EQ(static_cast<double>(values[2 * n + i]), cloud.z[i]);
  }
  EXPECT_EQ("PCD, binary_compressed", cloud.format);
}

TEST(Pcd, FieldsComeInAnyOrderCaseSizeAndCount)
{
  const std::string head =
      header("FIELDS histogram Z _ y GpsTime X Intensity Classification rgb",
             "SIZE 4 8 1 4 8 4 2 1 4\nTYPE F F U f F i U u F", "COUNT 3 1 5 1 1 1 1 1 1", 2);
  const auto point = [](double z, float y, double time, std::int32_t x, std::uint16_t intensity,
                        std::uint8_t itsClass)
  {
    return floats({9, 9, 9}) + bytesOf(z) + std::string(5, 'p') + bytesOf(y) + bytesOf(time) +
           bytesOf(x) + bytesOf(intensity) + bytesOf(itsClass) + floats({7});
  };
  const std::string first = point(3.5, 2, 99.5, -1, 60000, 2), second = point(6, 5, 100, 4, 7, 255);
  const auto check = [](const PointCloud& cloud)
  {
    EXPECT_EQ((std::vector<double>{-1, 4}), cloud.x);
    EXPECT_EQ((std::vector<double>{2, 5}), cloud.y);
    EXPECT_EQ((std::vector<double>{3.5, 6}), cloud.z);
    EXPECT_EQ((std::vector<double>{99.5, 100}), cloud.time);
    EXPECT_EQ((std::vector<float>{60000, 7}), cloud.intensity);
    EXPECT_EQ((std::vector<std::uint8_t>{2, 255}), cloud.classification);
    EXPECT_EQ((std::vector<std::string>{"histogram", "rgb"}), cloud.otherFields);
  };
  check(readBytesAs("a.pcd", head + "DATA binary\n" + first + second));
  check(readBytesAs("a.pcd", head + "DATA ascii\n9 9 9 3.5 1 2 3 4 5 2 99.5 -1 60000 2 7\n"
                                    "9 9 9 6 1 2 3 4 5 5 100 4 7 255 7\n"));
  std::string columns;
  for (const auto& [at, size] : std::vector<std::pair<std::size_t, std::size_t>>{
           {0, 12}, {12, 8}, {20, 5}, {25, 4}, {29, 8}, {37, 4}, {41, 2}, {43, 1}, {44, 4}})
    columns += first.substr(at, size) + second.substr(at, size);
  check(readBytesAs("a.pcd", head + "DATA binary_compressed\n" + packed(columns)));
}

TEST(Pcd, AllTypesOfNumbersAreRead)
{
  const auto zOf = [](const std::string& type, std::size_t size, const std::string& bytes)
  {
    return readBytesAs("a.pcd", header("FIELDS x y z",
                                       "SIZE 4 4 " + std::to_string(size) + "\nTYPE F F " + type,
                                       "COUNT 1 1 1", 1) +
                                    "DATA binary\n" + floats({1, 2}) + bytes)
        .z[0];
  };
  EXPECT_EQ(-5, zOf("I", 1, bytesOf(std::int8_t(-5))));
  EXPECT_EQ(250, zOf("U", 1, bytesOf(std::uint8_t(250))));
  EXPECT_EQ(-300, zOf("I", 2, bytesOf(std::int16_t(-300))));
  EXPECT_EQ(9999, zOf("U", 2, bytesOf(std::uint16_t(9999))));
  EXPECT_EQ(-7, zOf("I", 4, bytesOf(std::int32_t(-7))));
  EXPECT_EQ(8, zOf("U", 4, bytesOf(std::uint32_t(8))));
  EXPECT_EQ(-8, zOf("I", 8, bytesOf(std::int64_t(-8))));
  EXPECT_EQ(9, zOf("U", 8, bytesOf(std::uint64_t(9))));
  EXPECT_EQ(0.5, zOf("F", 4, bytesOf(0.5F)));
  EXPECT_EQ(0.1, zOf("F", 8, bytesOf(0.1)));
  expectRefused(
      "a.pcd",
      header("FIELDS x y z", "SIZE 4 4 3\nTYPE F F F", "COUNT 1 1 1", 1) + "DATA ascii\n1 2 3",
      "its field z is of TYPE F, SIZE 3 and COUNT 1");
}

TEST(Pcd, OrganisedCloudsHavePointsThatAreNone)
{
  const std::string head =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 2\nPOINTS "
      "4\n";
  const PointCloud cloud = readBytesAs(
      "a.pcd", head + "DATA binary\n" + floats({kNan, kNan, kNan, 1, 2, 3, 1, kNan, 3, 4, 5, 6}));
  EXPECT_EQ((std::vector<double>{1, 4}), cloud.x);
  EXPECT_EQ(2U, cloud.notFinite);
  EXPECT_EQ(
      2U,
      readBytesAs("a.pcd", head + "DATA ascii\nnan nan nan\n1 2 3\n1 -inf 2\n1 1 1\n").notFinite);
  expectRefused("a.pcd", head + "DATA ascii\nnan 1 1\nnan 1 1\nnan 1 1\n1 1 nan\n",
                "no usable point: a coordinate of each of its 4 is NaN or infinite");
}

TEST(Pcd, OldHeadersLackLines)
{
  const PointCloud cloud =
      readBytesAs("a.pcd", "VERSION 0.6\nCOLUMNS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n");
  EXPECT_EQ(3, cloud.z[0]);
  EXPECT_EQ(1U,
            readBytesAs("a.pcd", "VERSION .5\nFIELDS x y z\nWIDTH 1\nDATA ascii\n1 2 3").size());
}

TEST(Pcd, TruncatedAndLyingFilesAreRefused)
{
  expectRefused("a.pcd", twoPoints("ascii") + "1 2 3\n",
                "promises 2 points, of which the file has 1");
  expectRefused("a.pcd", twoPoints("binary") + floats({1, 2, 3, 4, 5}), "of which the file has 1");
  expectRefused("a.pcd", twoPoints("binary_compressed") + "abc", "truncated before its packed");
  const std::string good = packed(floats({1, 1, 1, 1, 1, 1}));
  expectRefused("a.pcd", twoPoints("binary_compressed") + good.substr(0, good.size() - 1),
                "truncated within its packed");
  expectRefused("a.pcd", twoPoints("binary_compressed") + packed(floats({1, 1, 1, 1, 1})),
                "promises 2 points of 12 bytes, its packed data 20 bytes");
  std::string damaged = good;
  damaged[8] = '\xFF';
  expectRefused("a.pcd", twoPoints("binary_compressed") + damaged, "packed points are damaged");
  const std::size_t many = 300000000;
  expectRefused("a.pcd",
                header("FIELDS x y z", "SIZE 4 4 4\nTYPE F F F", "COUNT 1 1 1", many) +
                    "DATA binary_compressed\n" + bytesOf(std::uint32_t(4)) +
                    bytesOf(static_cast<std::uint32_t>(12 * many)) + "abcd",
                "packed points are damaged");
  expectRefused("a.pcd", "VERSION .7\nFIELDS x y z\nWIDTH 2\nHEIGHT 3\nPOINTS 7\nDATA ascii\n",
                "POINTS 7, but WIDTH 2 and HEIGHT 3");
  expectRefused("a.pcd",
                "VERSION .7\nFIELDS x y z\nWIDTH 18446744073709551615\nHEIGHT 3\nDATA ascii\n",
                "but WIDTH 18446744073709551615");
  expectRefused("a.pcd", "VERSION .7\nFIELDS x y z\nPOINTS 18446744073709551615\nDATA binary\nab",
                "of which the file has 0");
  expectRefused("a.pcd", "VERSION .7\nFIELDS x y z\nWIDTH 0\nDATA ascii\n", "holds no point");
}

TEST(Pcd, BrokenHeadersAreNamedByLine)
{
  const auto headed = [](const std::string& lines) { return "VERSION .7\nFIELDS x y z\n" + lines; };
  expectRefused("a.pcd", headed("POINTS two\nDATA ascii\n"), "line 3: 'two' is no whole number");
  expectRefused("a.pcd", headed("POINTS 1\nDATA zip\n"), "line 4: DATA is zip; ascii, binary");
  expectRefused("a.pcd", headed("POINTS 1\n"), "no line DATA");
  expectRefused("a.pcd", headed("DATA ascii\n1 2 3\n"), "neither POINTS nor WIDTH");
  expectRefused("a.pcd", headed("SIZE 4 4\nPOINTS 1\nDATA ascii\n"),
                "its line SIZE has 2 values for 3 fields");
  expectRefused("a.pcd", headed("COUNT 1 1 99999999999\nPOINTS 1\nDATA ascii\n"),
                "COUNT 99999999999, which is not read");
  expectRefused("a.pcd", "VERSION .7\nFIELDS x y w\nPOINTS 1\nDATA ascii\n1 2 3\n",
                "not all of the coordinates");
}

TEST(Pcd, BrokenLinesAreNamedByNumber)
{
  expectRefused("a.pcd", twoPoints("ascii") + "1 2 3\n1 2 x3\n",
                "line 13: 'x3' in column 3 is no number");
  expectRefused("a.pcd", twoPoints("ascii") + "1 2\n",
                "line 12: has 2 columns where points have 3");
  expectRefused("a.pcd",
                header("FIELDS x y z class", "SIZE 4 4 4 1\nTYPE F F F U", "COUNT 1 1 1 1", 1) +
                    "DATA ascii\n1 2 3 256\n",
                "classification = 256 is not valid: it must be a whole number of 0 to 255");
}

// Values by a few lines of Python's struct, from the same bytes.
TEST(Pcd, ReadsRealFiles)
{
  const std::string real = MRPT_MAPCONV_SHARED_DIR "/real/";
  if (!std::filesystem::exists(real)) GTEST_SKIP() << real << " is not there";
  const PointCloud utm = readCloudFile(real + "autzen-utm.pcd");
  ASSERT_EQ(1065U, utm.size());
  EXPECT_EQ(mrpt::math::TPoint3D(494428, 4877455, 0), utm.origin);
  EXPECT_NEAR(0.61, utm.x[0], 1e-9);
  EXPECT_NEAR(4878741.67, utm.origin.y + utm.y[1064], 1e-6);
  EXPECT_EQ(249773.20172406783, utm.time[1064]);
  EXPECT_EQ(1341, std::accumulate(utm.classification.begin(), utm.classification.end(), 0));
  EXPECT_EQ(81361, std::accumulate(utm.intensity.begin(), utm.intensity.end(), 0.0));
  EXPECT_EQ(8U, utm.otherFields.size());

  EXPECT_EQ(38010U, readCloudFile(real + "isprs_samp11.pcd").size());
  EXPECT_EQ(21786U, readCloudFile(real + "isprs_samp11_ground.pcd").size());
  for (const char* name : {"isprs_samp31", "isprs_samp52"})
    EXPECT_LT(readCloudFile(real + name + "_ground.pcd").size(),
              readCloudFile(real + name + ".pcd").size());
}
