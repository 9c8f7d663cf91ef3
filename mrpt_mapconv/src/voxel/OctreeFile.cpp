#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/files/ForeignKind.h>
#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <octomap/OcTreeStamped.h>

#include <algorithm>
#include <istream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "BytesBuffer.h"
#include "GridToOctree.h"
#include "OctreeHeader.h"
#include "OctreeNodeCheck.h"
#include "OctreeToGrid.h"

namespace mrpt_mapconv::voxel
{
namespace
{
using octomap::AbstractOccupancyOcTree;

/** The occupancy trees that OctoMap ships, and what their nodes store in an `.ot` file besides the
 * occupancy (OcTreeStamped does not write its time stamps). */
struct TreeType
{
  std::unique_ptr<AbstractOccupancyOcTree> tree;
  std::size_t extraBytes;
};

TreeType makeTree(const std::string& id, double resolution)
{
  // Not AbstractOcTree::createTree(), which complains on stderr and makes other trees as well.
  if (id == "OcTree") return {std::make_unique<octomap::OcTree>(resolution), 0};
  if (id == "ColorOcTree") return {std::make_unique<octomap::ColorOcTree>(resolution), 3};
  if (id == "OcTreeStamped") return {std::make_unique<octomap::OcTreeStamped>(resolution), 0};
  throw std::runtime_error("the tree's type is '" + params::printable(id, 40) +
                           "'; OcTree, ColorOcTree and OcTreeStamped can be read");
}

/** Bytes behind the last node that mean nothing: an editor that changed the header's comments ends
 * the file with a new line. */
bool isPadding(std::string_view bytes)
{
  return bytes.find_first_not_of(std::string_view("\n\r\0", 3)) == std::string_view::npos;
}

void checkNodes(const OctreeHeader& header, std::string_view data, std::size_t extraBytes)
{
  const auto promised = "the header promises " + std::to_string(header.nodes) + " nodes, ";
  if (header.nodes == 0)
  {
    if (!isPadding(data)) throw std::runtime_error(promised + "but data follow");
    return;
  }
  const NodeCheck check = header.binary ? checkBinaryNodes(data) : checkFullNodes(data, extraBytes);
  if (check.fault)
    throw std::runtime_error(promised + "but the one at byte " +
                             std::to_string(header.length + check.bytes) +
                             " of the file is damaged: " + check.fault);
  if (check.nodes != header.nodes)
    throw std::runtime_error(promised + std::to_string(check.nodes) + " follow");
  if (!isPadding(data.substr(check.bytes)))
    throw std::runtime_error(promised + "but " + std::to_string(data.size() - check.bytes) +
                             " bytes follow the last one");
}

std::unique_ptr<octomap::AbstractOcTree> parse(std::string_view bytes)
{
  const OctreeHeader header = parseOctreeHeader(bytes);
  TreeType made = makeTree(header.id, header.resolution);
  const std::string_view data = bytes.substr(header.length);
  checkNodes(header, data, made.extraBytes);
  if (header.nodes > 0)
  {
    BytesBuffer buffer(data);
    std::istream stream(&buffer);
    if (header.binary)
      made.tree->readBinaryData(stream);
    else
      made.tree->readData(stream);
  }
  return std::move(made.tree);
}

/** Calls `read`; its errors get the file's name. */
template <class Read>
auto naming(const std::string& name, const Read& read)
try
{
  return read();
}
catch (const LeafTooLarge& e)
{
  throw LeafTooLarge(name + ": " + e.what());
}
catch (const std::runtime_error& e)
{
  throw std::runtime_error(name + ": " + e.what());
}

VoxelGrid emptyGrid(double resolution)
try
{
  return VoxelGrid(resolution);
}
catch (const std::invalid_argument& e)
{
  throw std::runtime_error(e.what());
}

/** The bytes of a file, but no more than a node that its header promises can need: a few packed
 * bytes can become any number. */
std::string readBytes(files::InputStream& stream)
{
  constexpr std::size_t kPiece = std::size_t(1) << 20U;
  constexpr std::uint64_t kNodeBytes = 8;  // the largest: a float, three bytes of colour, a mask
  std::string bytes = stream.readUpTo(kPiece);
  if (bytes.size() < kPiece) return bytes;
  const auto header = naming(stream.name(), [&] { return parseOctreeHeader(bytes); });
  const auto promised =
      std::min(header.nodes, std::numeric_limits<std::uint64_t>::max() / (2 * kNodeBytes));
  bytes += stream.readUpTo(header.length + promised * kNodeBytes);
  return bytes;
}
}  // namespace

std::unique_ptr<octomap::AbstractOcTree> readOctreeFile(const std::string& path)
{
  files::InputStream stream(path);
  return readOctree(stream);
}

std::unique_ptr<octomap::AbstractOcTree> readOctree(files::InputStream& stream)
{
  if (!beginsAsOctree(stream.preview())) files::refuseForeignKinds(stream);
  const std::string bytes = readBytes(stream);
  return naming(stream.name(), [&] { return parse(bytes); });
}

std::unique_ptr<octomap::AbstractOcTree> readOctree(const std::string& bytes,
                                                    const std::string& name)
{
  return naming(name, [&] { return parse(bytes); });
}

void writeOctreeFile(const std::string& path, const AbstractOccupancyOcTree& tree,
                     const std::string& remark)
{
  std::ostringstream nodes;
  tree.writeBinaryData(nodes);
  files::writeFile(path, octreeHeaderText(octreeHeaderOf(tree, true), remark) + nodes.str());
}

void writeOctreeFile(const std::string& path, const VoxelGrid& grid, bool pruned,
                     const std::string& remark)
{
  const OctreeNodes nodes = binaryNodes(grid, pruned);
  const OctreeHeader header{true, "OcTree", nodes.count, grid.resolution()};
  files::writeFile(path, octreeHeaderText(header, remark) + nodes.bytes);
}

std::string fullOctree(const VoxelGrid& grid, bool pruned)
{
  const OctreeNodes nodes = fullNodes(grid, pruned);
  return octreeHeaderText({false, "OcTree", nodes.count, grid.resolution()}) + nodes.bytes;
}

VoxelGrid readVoxelGrid(std::string_view bytes, const std::string& name,
                        const std::optional<std::int32_t>& maxMemory)
{
  return naming(name,
                [&]
                {
                  const OctreeHeader header = parseOctreeHeader(bytes);
                  if (header.binary)
                    throw std::runtime_error("is a binary octree (.bt) where a full one belongs");
                  if (header.id != "OcTree")
                    throw std::runtime_error("holds a " + params::printable(header.id, 40) +
                                             " where an OcTree belongs");
                  const std::string_view data = bytes.substr(header.length);
                  checkNodes(header, data, 0);
                  VoxelGrid grid = emptyGrid(header.resolution);
                  if (header.nodes > 0) addFullNodes(data, maxMemory, grid);
                  return grid;
                });
}

std::string fullOctree(const AbstractOccupancyOcTree& tree)
{
  std::ostringstream nodes;
  if (tree.size() > 0) tree.writeData(nodes);
  return octreeHeaderText(octreeHeaderOf(tree, false)) + nodes.str();
}

}  // namespace mrpt_mapconv::voxel
