#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace octomap
{
class AbstractOcTree;
}

namespace mrpt_mapconv::voxel
{
/** The text in front of an OctoMap file's nodes. */
struct OctreeHeader
{
  bool binary = false;      //!< `.bt` (two bits per child) or `.ot` (values and child bits)
  std::string id;           //!< the tree's type
  std::uint64_t nodes = 0;  //!< how many nodes the header promises (`size`)
  double resolution = 0;    //!< edge of the finest voxel [m], finite and > 0
  std::size_t length = 0;   //!< bytes of header; the nodes begin here
};

/** Reads the header as OctoMap's own readHeader does: words in any order until `data`, `#` starts a
 * comment, a line with an unknown keyword is skipped, the id "1" of the first files means OcTree.
 * Stricter than OctoMap where it would read nonsense: `id`, `size` and `res` must all be there, and
 * be whole numbers where numbers are due.
 * \exception std::runtime_error saying what is wrong, without the file's name */
OctreeHeader parseOctreeHeader(std::string_view bytes);

/** The text in front of a tree's nodes, in the C locale and with all digits of the resolution.
 * \param header what it says; `length` is not used */
std::string octreeHeaderText(const OctreeHeader& header, const std::string& remark = {});
/** That of a tree, whose type a `.bt` file does not keep. */
OctreeHeader octreeHeaderOf(const octomap::AbstractOcTree& tree, bool binary);

}  // namespace mrpt_mapconv::voxel
