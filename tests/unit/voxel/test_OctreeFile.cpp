#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <octomap/ColorOcTree.h>
#include <octomap/CountingOcTree.h>
#include <octomap/OcTree.h>
#include <octomap/OcTreeStamped.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "support/TempDir.h"

namespace
{
using mrpt_mapconv::voxel::readOctree;
using mrpt_mapconv::voxel::readOctreeFile;

enum class Format
{
  Binary,
  Full
};

/** A tree with leaves on several levels: a big free box, a wall in it and scattered voxels. */
template <class Tree>
void fill(Tree& tree)
{
  for (int x = -8; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      for (int z = 0; z < 8; ++z)
        tree.setNodeValue(octomap::OcTreeKey(static_cast<octomap::key_type>(32768 + x),
                                             static_cast<octomap::key_type>(32768 + y),
                                             static_cast<octomap::key_type>(32768 + z)),
                          x == 3 ? 1.5f : -0.75f);
  tree.setNodeValue(octomap::OcTreeKey(0, 0, 0), 0.25f);
  tree.setNodeValue(octomap::OcTreeKey(65535, 40000, 12345), -0.5f);
  tree.updateInnerOccupancy();
  tree.prune();
}

void paint(octomap::OcTree&) {}
void paint(octomap::OcTreeStamped&) {}
void paint(octomap::ColorOcTree& tree)
{
  unsigned i = 0;
  for (auto it = tree.begin_leafs(); it != tree.end_leafs(); ++it, ++i)
    it->setColor(static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(7 * i), 9);
}

template <class Tree>
std::unique_ptr<Tree> sampleTree(double resolution = 0.1)
{
  auto tree = std::make_unique<Tree>(resolution);
  fill(*tree);
  paint(*tree);
  return tree;
}

template <class Tree>
std::string written(Tree& tree, Format format)
{
  std::ostringstream out;
  if (format == Format::Binary)
    tree.writeBinary(out);
  else
    tree.write(out);
  return out.str();
}

std::string sampleBytes(Format format) { return written(*sampleTree<octomap::OcTree>(), format); }

std::string header(const std::string& lines, bool binary = true)
{
  return (binary ? "# Octomap OcTree binary file\n" : "# Octomap OcTree file\n") + lines;
}

/** The message that reading these bytes throws; fails the test if none is thrown. */
std::string errorOf(const std::string& bytes)
{
  testing::internal::CaptureStderr();
  std::string message;
  try
  {
    readOctree(bytes, "map.bt");
    ADD_FAILURE() << "was read";
  }
  catch (const std::runtime_error& e)
  {
    message = e.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(message.rfind("map.bt: ", 0), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message;
}

void expectError(const std::string& bytes, const std::string& part)
{
  const std::string message = errorOf(bytes);
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

void expectSameColor(const octomap::OcTreeNode&, const octomap::OcTreeNode&) {}
void expectSameColor(const octomap::ColorOcTreeNode& a, const octomap::ColorOcTreeNode& b)
{
  EXPECT_TRUE(a.getColor() == b.getColor());
}

/** The same leaves, with the same values and colours, of the same depth at the same places. */
template <class Tree>
void expectSame(const Tree& expected, const octomap::AbstractOcTree& got)
{
  const auto* tree = dynamic_cast<const Tree*>(&got);
  ASSERT_NE(tree, nullptr) << got.getTreeType();
  EXPECT_EQ(tree->getResolution(), expected.getResolution());
  ASSERT_EQ(tree->size(), expected.size());
  auto a = expected.begin_leafs();
  for (auto b = tree->begin_leafs(); b != tree->end_leafs(); ++a, ++b)
  {
    ASSERT_TRUE(a != expected.end_leafs());
    ASSERT_TRUE(a.getKey() == b.getKey());
    ASSERT_EQ(a.getDepth(), b.getDepth());
    ASSERT_EQ(a->getLogOdds(), b->getLogOdds());
    expectSameColor(*a, *b);
  }
  EXPECT_TRUE(a == expected.end_leafs());
}

template <class Tree>
class OctreeFileOf : public testing::Test
{
};
using Trees = testing::Types<octomap::OcTree, octomap::ColorOcTree, octomap::OcTreeStamped>;
TYPED_TEST_SUITE(OctreeFileOf, Trees);

TYPED_TEST(OctreeFileOf, FullRoundTrip)
{
  const auto tree = sampleTree<TypeParam>();
  expectSame(*tree, *readOctree(written(*tree, Format::Full), "memory"));
}

TYPED_TEST(OctreeFileOf, BinaryRoundTrip)
{
  const auto tree = sampleTree<TypeParam>(0.07);
  const std::string bytes = written(*tree, Format::Binary);
  TypeParam reference(0.1);
  std::istringstream in(bytes);
  ASSERT_TRUE(reference.readBinary(in));
  expectSame(reference, *readOctree(bytes, "memory"));
}

TYPED_TEST(OctreeFileOf, EmptyTree)
{
  TypeParam tree(0.3);
  for (const Format format : {Format::Binary, Format::Full})
  {
    const auto got = readOctree(written(tree, format), "memory");
    EXPECT_EQ(got->size(), 0u);
    EXPECT_EQ(got->getTreeType(), tree.getTreeType());
    EXPECT_EQ(got->getResolution(), 0.3);
  }
}

TYPED_TEST(OctreeFileOf, EveryTruncationThrows)
{
  TypeParam tree(0.1);
  tree.setNodeValue(octomap::OcTreeKey(32768, 32768, 32768), 1.0f);
  tree.setNodeValue(octomap::OcTreeKey(32767, 32768, 32768), -1.0f);
  for (const Format format : {Format::Binary, Format::Full})
  {
    const std::string bytes = written(tree, format);
    for (std::size_t n = 0; n < bytes.size(); ++n)
      EXPECT_THROW(readOctree(bytes.substr(0, n), "cut"), std::runtime_error) << n;
    EXPECT_NO_THROW(readOctree(bytes, "whole"));
  }
}

TEST(OctreeFile, UnprunedFullTreeKeepsItsNodes)
{
  octomap::OcTree tree(0.05);
  fill(tree);
  tree.expand();
  expectSame(tree, *readOctree(written(tree, Format::Full), "memory"));
}

TEST(OctreeFile, HeaderIsReadAsLenientlyAsOctoMapDoes)
{
  const std::string bytes = sampleBytes(Format::Binary);
  const auto tree = readOctree(bytes, "memory");
  const std::string data = bytes.substr(bytes.find("\ndata\n") + 6);
  const std::string size = std::to_string(tree->size());
  for (const std::string& lines :
       {"id 1\nsize " + size + "\nres 0.1\ndata\n",
        "res 0.1\n#\n# a comment with the word data\nsize " + size + "\nid OcTree\ndata\n",
        "id\tOcTree size " + size + " res 1e-1 data and more\n",
        "id OcTree\r\nsize " + size + "\r\nres 0.1\r\ndata\r\n",
        "colour 3 id Nonsense\nid OcTree\nsize " + size + "\nres 0.1\ndata\n"})
  {
    SCOPED_TRACE(lines);
    testing::internal::CaptureStderr();
    const auto got = readOctree(header(lines) + data, "memory");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    expectSame(dynamic_cast<const octomap::OcTree&>(*tree), *got);
  }
}

TEST(OctreeFile, AnEditorsNewLineAtTheEndIsNoDamage)
{
  for (const Format format : {Format::Binary, Format::Full})
  {
    const std::string bytes = sampleBytes(format);
    EXPECT_NO_THROW(readOctree(bytes + "\n", "memory"));
    expectError(bytes + "more", "4 bytes follow the last one");
  }
}

TEST(OctreeFile, WrongNodeCountIsNamed)
{
  for (const Format format : {Format::Binary, Format::Full})
  {
    std::string bytes = sampleBytes(format);
    const std::string size = std::to_string(readOctree(bytes, "memory")->size());
    const std::size_t at = bytes.find("size " + size) + 5;
    expectError(bytes.replace(at, size.size(), "100000"),
                "promises 100000 nodes, " + size + " follow");
    expectError(bytes.replace(at, 6, "0"), "promises 0 nodes, but data follow");
    expectError(bytes.replace(at, 1, "99999999999999999999"), "no valid number");
    expectError(bytes.replace(at, 20, "-1"), "'size' is '-1'");
  }
}

TEST(OctreeFile, BadHeadersAreNamed)
{
  expectError("", "empty");
  expectError("hello", "not an OctoMap file");
  expectError(std::string(1000, '\0'), "not an OctoMap file");
  expectError(header(""), "no 'data' line");
  expectError(header("id OcTree\nsize 1\nres 0.1\n"), "no 'data' line");
  expectError(header("id OcTree\nsize 1\nres 0.1\ndata"), "has no end");
  expectError(header("size 1\nres 0.1\ndata\n"), "no 'id'");
  expectError(header("id OcTree\nres 0.1\ndata\n"), "no 'size'");
  expectError(header("id OcTree\nsize 1\ndata\n"), "no 'res'");
  for (const char* res : {"0", "-0.1", "inf", "nan"})
    expectError(header("id OcTree\nsize 1\nres " + std::string(res) + "\ndata\n"),
                "finite number above 0");
  for (const char* res : {"banana", "0,1", "0.1m", "1e999", "data"})
    expectError(header("id OcTree\nsize 1\nres " + std::string(res) + "\ndata\n"),
                std::string("'res' is '") + res);
}

TEST(OctreeFile, OtherTreesAreNamedWithWhatIsSupported)
{
  octomap::CountingOcTree counting(0.1);
  counting.updateNode(octomap::point3d(1, 2, 3));
  std::ostringstream out;
  counting.write(out);
  expectError(out.str(), "'" + counting.getTreeType() + "'; OcTree, ColorOcTree and OcTreeStamped");
  expectError(header("id \x1b[31mEvil\nsize 1\nres 0.1\ndata\n"), "'\\x1b[31mEvil'");
  expectError(header("id " + std::string(5000, 'x') + "\nsize 1\nres 1\ndata\n"), "xxx...'");
}

TEST(OctreeFile, TooDeepTreesAreRefused)
{
  // an inner node's first child is an inner node, and so on: 0b11 in the lowest two bits
  const auto binaryChain = [](int inner)
  {
    std::string data;
    for (int i = 0; i + 1 < inner; ++i) data += std::string("\x03\0", 2);
    return header("id OcTree\nsize " + std::to_string(inner + 1) + "\nres 0.1\ndata\n") + data +
           std::string("\x02\0", 2);
  };
  EXPECT_EQ(readOctree(binaryChain(16), "memory")->size(), 17u);
  expectError(binaryChain(17), "16 levels");
  expectError(binaryChain(1000000), "16 levels");

  const auto fullChain = [](int nodes)
  {
    std::string data;
    for (int i = 0; i < nodes; ++i)
      data += std::string("\0\0\0\0", 4) + (i + 1 < nodes ? '\1' : '\0');
    return header("id OcTree\nsize " + std::to_string(nodes) + "\nres 0.1\ndata\n", false) + data;
  };
  EXPECT_EQ(readOctree(fullChain(17), "memory")->size(), 17u);
  expectError(fullChain(18), "16 levels");
  expectError(fullChain(1000000), "16 levels");
}

TEST(OctreeFile, InnerNodesWithoutChildrenAreRefused)
{
  expectError(header("id OcTree\nsize 2\nres 0.1\ndata\n") + std::string("\x03\0\0\0", 4),
              "without any child");
}

TEST(OctreeFile, ValuesThatAreNotFiniteAreRefused)
{
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
  {
    std::string data(5, '\0');
    std::memcpy(&data[0], &value, sizeof(value));
    expectError(header("id OcTree\nsize 1\nres 0.1\ndata\n", false) + data, "not a finite number");
  }
}

TEST(OctreeFile, RandomDamageNeverCrashes)
{
  constexpr unsigned kSeed = 20240501;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  int readable = 0;
  for (const Format format : {Format::Binary, Format::Full})
  {
    const std::string whole = sampleBytes(format);
    for (int round = 0; round < 3000; ++round)
    {
      std::string bytes = whole;
      for (std::size_t hits = 1 + random() % 4; hits > 0; --hits)
        bytes[random() % bytes.size()] = static_cast<char>(random());
      try
      {
        const auto tree = readOctree(bytes, "damaged");
        ASSERT_NE(tree, nullptr);
        readable += tree->size() > 0;
      }
      catch (const std::runtime_error&)
      {
      }
    }
  }
  // damage to a comment or a value leaves a readable file
  EXPECT_GT(readable, 0);
}

class OctreeFileOnDisk : public testing::Test
{
 protected:
  std::string write(const std::string& name, const std::string& bytes) const
  {
    const std::string path = m_dir.path(name);
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  static void expectFileError(const std::string& path, const std::string& part)
  {
    try
    {
      readOctreeFile(path);
      ADD_FAILURE() << path << " was read";
    }
    catch (const std::runtime_error& e)
    {
      EXPECT_EQ(std::string(e.what()).rfind(path + ": ", 0), 0u) << e.what();
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    }
  }

  mrpt_mapconv::testing::TempDir m_dir;
};

TEST_F(OctreeFileOnDisk, ReadsWhatOctoMapWrote)
{
  const auto tree = sampleTree<octomap::ColorOcTree>();
  // The first line tells the format, not the extension.
  expectSame(*tree, *readOctreeFile(write("a map.bt", written(*tree, Format::Full))));
}

TEST_F(OctreeFileOnDisk, BadFilesAreNamed)
{
  expectFileError(m_dir.path("missing.bt"), "no such file");
  expectFileError(m_dir.path(), "is a directory");
  expectFileError(write("empty.bt", ""), "empty");
  expectFileError(write("garbage.bt", "PK \x03\x04 garbage"), "not an OctoMap file");
  expectFileError(write("zip.bt", "PK\x03\x04 map.bt"), "is a zip archive; unpack it");
}

TEST_F(OctreeFileOnDisk, WritesWhatItReads)
{
  const auto tree = sampleTree<octomap::ColorOcTree>();
  const std::string path = m_dir.path("written.bt");
  mrpt_mapconv::voxel::writeOctreeFile(path, *tree, "a remark");
  const auto read = readOctreeFile(path);
  EXPECT_EQ("OcTree", read->getTreeType());
  const auto& copy = dynamic_cast<const octomap::OcTree&>(*read);
  std::size_t leaves = 0;
  for (auto it = tree->begin_leafs(); it != tree->end_leafs(); ++it, ++leaves)
  {
    const auto* node = copy.search(it.getKey(), it.getDepth());
    ASSERT_TRUE(node);
    EXPECT_EQ(tree->isNodeOccupied(*it), copy.isNodeOccupied(*node));
  }
  EXPECT_EQ(leaves, copy.getNumLeafNodes());
}

TEST_F(OctreeFileOnDisk, KeepsAllDigitsOfTheResolution)
{
  octomap::OcTree tree(0.123456789012);
  tree.updateNode(octomap::point3d(0.1f, 0.2f, 0.3f), true);
  const std::string path = m_dir.path("odd.bt");
  mrpt_mapconv::voxel::writeOctreeFile(path, tree);
  EXPECT_EQ(0.123456789012, readOctreeFile(path)->getResolution());
}

TEST_F(OctreeFileOnDisk, SaysWhyItCannotWrite)
{
  octomap::OcTree tree(0.1);
  tree.updateNode(octomap::point3d(0.1f, 0.2f, 0.3f), true);
  const std::string path = m_dir.path("no/such/folder.bt");
  try
  {
    mrpt_mapconv::voxel::writeOctreeFile(path, tree);
    ADD_FAILURE() << "written";
  }
  catch (const std::runtime_error& e)
  {
    EXPECT_NE(std::string(e.what()).find(path), std::string::npos) << e.what();
  }
}

TEST(OctreeFileReal, CorridorHasItsKnownLeaves)
{
  const std::string path = std::string(MRPT_MAPCONV_SHARED_DIR) + "/geb079.bt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  using Clock = std::chrono::steady_clock;
  const auto t0 = Clock::now();
  const auto read = readOctreeFile(path);
  const auto t1 = Clock::now();
  octomap::OcTree reference(path);
  const auto t2 = Clock::now();
  RecordProperty("timeOverOctoMap",
                 std::to_string((t1 - t0) / std::chrono::duration<double>(t2 - t1)));

  const auto& tree = dynamic_cast<const octomap::OcTree&>(*read);
  EXPECT_EQ(tree.size(), 532566u);
  std::size_t leaves = 0, occupied = 0;
  for (auto it = tree.begin_leafs(); it != tree.end_leafs(); ++it)
  {
    ++leaves;
    occupied += tree.isNodeOccupied(*it);
  }
  EXPECT_EQ(leaves, 428144u);
  EXPECT_EQ(occupied, 143729u);
  expectSame(reference, tree);
}
}  // namespace
