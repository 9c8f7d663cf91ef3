#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mrpt_mapconv::voxel
{
/** What the nodes of an OctoMap file look like when they are walked on the bytes alone. */
struct NodeCheck
{
  std::uint64_t nodes = 0;      //!< nodes that were complete, the root included
  std::size_t bytes = 0;        //!< bytes that they take
  const char* fault = nullptr;  //!< what is wrong with the node at `bytes`; nullptr: all is well
};

/** Walks the nodes of a `.bt` file: 16 bits per inner node, two for each child (00 unknown, 01 and
 * 10 leaves, 11 an inner node, which follows depth first). Stops at the first fault. */
NodeCheck checkBinaryNodes(std::string_view bytes);

/** Walks the nodes of an `.ot` file: for every node a float, `extraBytes` bytes more of payload and
 * a byte with one bit per child, depth first. Stops at the first fault. */
NodeCheck checkFullNodes(std::string_view bytes, std::size_t extraBytes);

}  // namespace mrpt_mapconv::voxel
