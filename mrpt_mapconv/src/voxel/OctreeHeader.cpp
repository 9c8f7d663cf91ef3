#include "OctreeHeader.h"

#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <octomap/AbstractOcTree.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <system_error>

namespace mrpt_mapconv::voxel
{
namespace
{
constexpr std::string_view kBinaryFile = "# Octomap OcTree binary file";
constexpr std::string_view kFullFile = "# Octomap OcTree file";
constexpr std::string_view kSpaces = " \t\n\v\f\r";

bool startsWith(std::string_view text, std::string_view begin)
{
  return text.substr(0, begin.size()) == begin;
}

/** Walks over the header's words and lines. */
class HeaderText
{
 public:
  explicit HeaderText(std::string_view bytes) : m_bytes(bytes) {}
  std::size_t position() const { return m_at; }

  /** The next word; empty at the end. */
  std::string_view word()
  {
    m_at = std::min(m_bytes.find_first_not_of(kSpaces, m_at), m_bytes.size());
    const std::size_t end = std::min(m_bytes.find_first_of(kSpaces, m_at), m_bytes.size());
    const std::string_view found = m_bytes.substr(m_at, end - m_at);
    m_at = end;
    return found;
  }

  /** Goes behind the end of the line. \return false if the line has no end */
  bool skipLine()
  {
    const std::size_t end = m_bytes.find('\n', m_at);
    m_at = end == std::string_view::npos ? m_bytes.size() : end + 1;
    return end != std::string_view::npos;
  }

 private:
  std::string_view m_bytes;
  std::size_t m_at = 0;
};

template <class Number>
Number parseNumber(const char* key, std::string_view word)
{
  Number value{};
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end)
    throw std::runtime_error(std::string("the header's '") + key + "' is '" +
                             params::printable(word, 40) + "', which is no valid number");
  return value;
}

bool isBinary(std::string_view bytes)
{
  if (bytes.empty()) throw std::runtime_error("the file is empty");
  if (startsWith(bytes, kBinaryFile)) return true;
  if (startsWith(bytes, kFullFile)) return false;
  throw std::runtime_error("not an OctoMap file: it does not begin with '" +
                           std::string(kBinaryFile) + "' (.bt) or '" + std::string(kFullFile) +
                           "' (.ot)");
}
}  // namespace

bool beginsAsOctree(std::string_view bytes)
{
  return startsWith(bytes, kBinaryFile) || startsWith(bytes, kFullFile);
}

OctreeHeader octreeHeaderOf(const octomap::AbstractOcTree& tree, bool binary)
{
  return {binary, binary ? "OcTree" : tree.getTreeType(), tree.size(), tree.getResolution()};
}

std::string octreeHeaderText(const OctreeHeader& header, const std::string& remark)
{
  // OctoMap writes the second line, and stored maps are held against it byte by byte.
  std::string text(header.binary ? kBinaryFile : kFullFile);
  if (!header.binary)
    text += "\n# (feel free to add / change comments, but leave the first line as it is!)\n#";
  if (!remark.empty()) text += "\n# " + remark;
  return text + "\nid " + header.id + "\nsize " + std::to_string(header.nodes) + "\nres " +
         params::shortestText(header.resolution) + "\ndata\n";
}

OctreeHeader parseOctreeHeader(std::string_view bytes)
{
  OctreeHeader header;
  header.binary = isBinary(bytes);
  std::optional<std::string_view> id;
  std::optional<std::uint64_t> nodes;
  std::optional<double> resolution;

  HeaderText text(bytes);
  for (std::string_view word = text.word(); word != "data"; word = text.word())
  {
    if (word.empty()) throw std::runtime_error("truncated: the header has no 'data' line");
    if (word == "id")
      id = text.word();
    else if (word == "size")
      nodes = parseNumber<std::uint64_t>("size", text.word());
    else if (word == "res")
      resolution = parseNumber<double>("res", text.word());
    else
      text.skipLine();
  }
  if (!text.skipLine()) throw std::runtime_error("truncated: the header's 'data' line has no end");
  header.length = text.position();

  if (!id || !nodes || !resolution)
    throw std::runtime_error(std::string("the header has no '") +
                             (!id ? "id" : (!nodes ? "size" : "res")) + "' line");
  if (!std::isfinite(*resolution) || *resolution <= 0)
    throw std::runtime_error("the header's 'res' is " + std::to_string(*resolution) +
                             ", but a voxel's size must be a finite number above 0");
  header.id = *id == "1" ? "OcTree" : std::string(*id);
  header.nodes = *nodes;
  header.resolution = *resolution;
  return header;
}

}  // namespace mrpt_mapconv::voxel
