#include <gtest/gtest.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>

#include <locale>
#include <sstream>

#include "support/Gzip.h"
#include "support/TempDir.h"

// Octrees that come gzipped, and headers in processes with another locale.
namespace mrpt_mapconv::voxel
{
using namespace mrpt_mapconv::testing;

namespace
{
octomap::OcTree manyVoxels()
{
  octomap::OcTree tree(0.1);
  for (int i = 0; i < 1500; ++i)
    tree.updateNode(octomap::point3d(0.1F * static_cast<float>(i), 0, 1), i % 3 == 0);
  return tree;
}

/** Numbers as they are written in much of Europe. */
class Separators : public std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class WithSeparators
{
 public:
  WithSeparators()
      : m_before(std::locale::global(std::locale(std::locale::classic(), new Separators)))
  {
  }
  ~WithSeparators() { std::locale::global(m_before); }

 private:
  std::locale m_before;
};
}  // namespace

TEST(OctreeFileForms, AGzippedFileIsReadWhateverItsName)
{
  const TempDir dir;
  const auto tree = manyVoxels();
  writeOctreeFile(dir.path("map.bt"), tree);
  writeGzipped(dir.path("map.bt.gz"), readBytes(dir.path("map.bt")));
  writeGzipped(dir.path("packed.bt"), readBytes(dir.path("map.bt")));
  writeGzipped(dir.path("map.ot.gz"), fullOctree(tree));
  for (const char* name : {"map.bt.gz", "packed.bt", "map.ot.gz"})
    EXPECT_EQ(tree.size(), readOctreeFile(dir.path(name))->size()) << name;
}

TEST(OctreeFileForms, AGzippedFileThatIsCutOffIsAnError)
{
  const TempDir dir;
  writeGzipped(dir.path("map.ot.gz"), fullOctree(manyVoxels()));
  const std::string whole = readBytes(dir.path("map.ot.gz"));
  for (const std::size_t kept : {std::size_t(12), whole.size() / 2, whole.size() - 1})
  {
    files::writeFile(dir.path("cut.ot.gz"), whole.substr(0, kept));
    const auto message = messageOf([&] { readOctreeFile(dir.path("cut.ot.gz")); });
    EXPECT_TRUE(contains(message, "cut.ot.gz: is truncated or damaged")) << message;
  }
}

TEST(OctreeFileForms, ErrorsNameTheFileWhateverItsSize)
{
  const TempDir dir;
  const std::string begin = "# Octomap OcTree binary file\n";
  for (const std::string& text : {std::string("no octree"), begin + "size 12a\n", begin + "id 1\n"})
    for (const std::size_t size : {text.size(), std::size_t(2000000)})
    {
      files::writeFile(dir.path("big.bt"), text + std::string(size - text.size(), '\1'));
      const auto message = messageOf([&] { readOctreeFile(dir.path("big.bt")); });
      EXPECT_EQ(0U, message.find(dir.path("big.bt") + ": ")) << message;
    }
}

TEST(OctreeFileForms, MoreBytesThanTheNodesNeedAreNotUnpacked)
{
  const TempDir dir;
  writeOctreeFile(dir.path("map.bt"), manyVoxels());
  writeGzipped(dir.path("bomb.bt"), readBytes(dir.path("map.bt")) + std::string(200U << 20U, 'x'));
  const auto message = messageOf([&] { readOctreeFile(dir.path("bomb.bt")); });
  EXPECT_TRUE(contains(message, "bytes follow the last one")) << message;
}

TEST(OctreeFileForms, HeadersDoNotDependOnTheLocale)
{
  const TempDir dir;
  const auto tree = manyVoxels();
  std::ostringstream octomaps;
  tree.write(octomaps);
  writeOctreeFile(dir.path("classic.bt"), tree);
  const WithSeparators locale;
  ASSERT_EQ("1.500", (std::ostringstream() << 1500).str());
  EXPECT_EQ(octomaps.str(), fullOctree(tree));
  writeOctreeFile(dir.path("map.bt"), tree);
  EXPECT_EQ(readBytes(dir.path("classic.bt")), readBytes(dir.path("map.bt")));
  EXPECT_EQ(tree.size(), readOctree(fullOctree(tree), "x")->size());
}

TEST(OctreeFileForms, AFullTreeKeepsColoursAndEmptiness)
{
  octomap::ColorOcTree tree(0.25);
  EXPECT_EQ(0U, readOctree(fullOctree(tree), "x")->size());
  tree.updateNode(octomap::point3d(0, 0, 0), true);
  tree.setNodeColor(0.1F, 0.1F, 0.1F, 1, 2, 3);
  std::ostringstream octomaps;
  tree.write(octomaps);
  EXPECT_EQ(octomaps.str(), fullOctree(tree));
}

}  // namespace mrpt_mapconv::voxel
