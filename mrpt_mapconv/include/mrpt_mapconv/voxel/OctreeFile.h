#pragma once

#include <mrpt_mapconv/files/InputStream.h>
#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace octomap
{
class AbstractOcTree;
class AbstractOccupancyOcTree;
}  // namespace octomap

namespace mrpt_mapconv::voxel
{
/** Whether these are the first bytes of an OctoMap file, `.bt` or `.ot`. */
bool beginsAsOctree(std::string_view bytes);

/** Reads an OctoMap file: `.bt` (binary) or `.ot` (full), told apart by their first line; gzipped
 * or not, whatever its name.
 *
 * The node structure is checked against the file's size and against the number of nodes that the
 * header promises before OctoMap itself reads it, so a damaged file is an error and not half a map.
 * \exception std::runtime_error naming the file and what is wrong with it: missing, empty, not an
 * OctoMap file (with what reads files of its kind, see files::foreignKindOf()), unknown tree type,
 * bad resolution, truncated, or a node count that does not fit */
std::unique_ptr<octomap::AbstractOcTree> readOctreeFile(const std::string& path);
/** The same of something that has been opened, and of which nothing has been read. */
std::unique_ptr<octomap::AbstractOcTree> readOctree(files::InputStream& stream);

/** The same from memory; `name` stands for the file in messages. */
std::unique_ptr<octomap::AbstractOcTree> readOctree(const std::string& bytes,
                                                    const std::string& name);

/** Writes a `.bt` file, which keeps of every leaf whether it is occupied or free, and the
 * resolution with all its digits. Unlike OctoMap's own writing it tells when the disk is full, and
 * prints nothing.
 * \param remark a line of text for the file's header, or none
 * \exception std::runtime_error naming the file and the reason if it cannot be written */
void writeOctreeFile(const std::string& path, const octomap::AbstractOccupancyOcTree& tree,
                     const std::string& remark = {});

/** The bytes of an `.ot` file, which keeps the occupancy of every node, whatever C++ locale the
 * process has (OctoMap's own writing puts separators into the numbers of its header). */
std::string fullOctree(const octomap::AbstractOccupancyOcTree& tree);

/** The same two of a VoxelGrid, as if it were the octree of its voxels.
 * \param pruned eight equal children become one node, as in a tree that OctoMap keeps pruned
 * \exception std::runtime_error if the grid reaches beyond an octree's range of ±32768 voxels @{ */
void writeOctreeFile(const std::string& path, const VoxelGrid& grid, bool pruned = true,
                     const std::string& remark = {});
std::string fullOctree(const VoxelGrid& grid, bool pruned = true);
/** @} */

/** Reads the bytes of an `.ot` file of an OcTree, with all checks of readOctree(), into a grid.
 * \param maxMemory of the grid [MB]; none: three quarters of the machine's
 * \exception std::runtime_error as readOctree(), and if the grid would exceed maxMemory */
VoxelGrid readVoxelGrid(std::string_view bytes, const std::string& name,
                        const std::optional<std::int32_t>& maxMemory = {});

}  // namespace mrpt_mapconv::voxel
