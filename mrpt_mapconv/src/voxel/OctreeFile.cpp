#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <octomap/OcTreeStamped.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <istream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string_view>

#include "OctreeHeader.h"
#include "OctreeNodeCheck.h"

namespace mrpt_mapconv::voxel
{
namespace
{
using octomap::AbstractOccupancyOcTree;

/** A stream buffer over bytes that stay where they are: a std::istringstream would copy them. */
class BytesBuffer : public std::streambuf
{
 public:
  explicit BytesBuffer(std::string_view bytes) : m_bytes(bytes) {}

 protected:
  std::streamsize xsgetn(char* to, std::streamsize wanted) override
  {
    const auto n = std::min(static_cast<std::size_t>(wanted), m_bytes.size());
    std::memcpy(to, m_bytes.data(), n);
    m_bytes.remove_prefix(n);
    return static_cast<std::streamsize>(n);
  }

 private:
  std::string_view m_bytes;
};

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
  throw std::runtime_error("the tree's type is '" + printable(id) +
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

std::string readBytes(const std::string& path)
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    throw std::runtime_error(status.type() == std::filesystem::file_type::not_found
                                 ? std::string("no such file")
                                 : error.message());
  if (std::filesystem::is_directory(status)) throw std::runtime_error("is a directory, not a file");

  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(std::string("cannot be opened: ") + std::strerror(errno));
  // In pieces, since a pipe does not tell its size.
  constexpr std::size_t kPiece = std::size_t(1) << 20;
  std::string bytes;
  if (std::filesystem::is_regular_file(status))
    bytes.reserve(static_cast<std::size_t>(std::filesystem::file_size(path)) + 2 * kPiece);
  for (std::size_t size = 0; file; bytes.resize(size))
  {
    bytes.resize(size + kPiece);
    file.read(&bytes[size], static_cast<std::streamsize>(kPiece));
    size += static_cast<std::size_t>(file.gcount());
  }
  if (file.bad()) throw std::runtime_error(std::string("cannot be read: ") + std::strerror(errno));
  return bytes;
}
}  // namespace

std::unique_ptr<octomap::AbstractOcTree> readOctreeFile(const std::string& path)
{
  try
  {
    return parse(readBytes(path));
  }
  catch (const std::runtime_error& e)
  {
    throw std::runtime_error(path + ": " + e.what());
  }
}

std::unique_ptr<octomap::AbstractOcTree> readOctree(const std::string& bytes,
                                                    const std::string& name)
{
  try
  {
    return parse(bytes);
  }
  catch (const std::runtime_error& e)
  {
    throw std::runtime_error(name + ": " + e.what());
  }
}

void writeOctreeFile(const std::string& path, const AbstractOccupancyOcTree& tree,
                     const std::string& remark)
{
  std::ostringstream bytes;
  bytes.precision(std::numeric_limits<double>::max_digits10);
  bytes << "# Octomap OcTree binary file\n";
  if (!remark.empty()) bytes << "# " << remark << "\n";
  bytes << "id OcTree\nsize " << tree.size() << "\nres " << tree.getResolution() << "\ndata\n";
  tree.writeBinaryData(bytes);
  files::writeFile(path, bytes.str());
}

}  // namespace mrpt_mapconv::voxel
