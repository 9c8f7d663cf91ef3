#pragma once

#include <octomap/OcTree.h>

#include <cstdint>
#include <vector>

#include "ScanBeams.h"

namespace mrpt_mapconv::voxel
{
/** The voxels that the beams of a scan go through or end in, each of them once, in the order in
 * which the tree holds them.
 *
 * The same voxels as in octomap::OcTree::computeUpdate(): a voxel in which a beam ends is no free
 * one, and a beam cut at the maximum range ends in none. But that keeps every voxel in a memory
 * block of its own, between the tree's nodes, and has them in no order: as a map grows, its
 * insertions become slower.
 */
class BeamVoxels
{
 public:
  BeamVoxels(const octomap::OcTree& tree, const ScanBeams& beams);

  /** Updates the tree: a miss for each free voxel, a hit for each one in which a beam ends. */
  void insertInto(octomap::OcTree& tree, bool lazy) const;

 private:
  /** A set of numbers in one block of memory. */
  class CodeSet
  {
   public:
    CodeSet();
    /** \return false if it was there */
    bool insert(std::uint64_t code);

   private:
    void grow();
    std::size_t slotOf(std::uint64_t code) const;
    std::vector<std::uint64_t> m_slots;  //!< code + 1; 0 is empty
    int m_bits;                          //!< there are 2^m_bits slots
    std::size_t m_size = 0;
  };

  void add(const octomap::OcTreeKey& key, std::vector<std::uint64_t>& codes);

  CodeSet m_known;
  std::vector<std::uint64_t> m_free, m_hit;  //!< Morton codes
};

}  // namespace mrpt_mapconv::voxel
