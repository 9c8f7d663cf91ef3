#pragma once

#include <cstdint>
#include <memory>

namespace octomap
{
class OcTree;
}

namespace mrpt_mapconv::sim
{
/** A generated building, about 12 × 8 × 2.6 m, as a scanner that went through it would have mapped
 * it: whatever can be seen from inside is occupied or free, everything else is unknown.
 *
 * Two rooms and a door with a lintel between them. West room: a table, a low wall (0.5 m), a shelf
 * and a window. East room: a ramp (slope 0.2) up to a platform (0.6 m). The floor's upper face is
 * z = 0; x is −4 … 8 m, y −3 … 5 m. The same bits on every call.
 *
 * \param resolution size of a voxel [m], 0.02 … 0.5
 * \return a pruned tree with clamped values, as OctoMap reads it from a `.bt` file
 * \exception std::invalid_argument for a resolution out of range */
std::unique_ptr<octomap::OcTree> buildingMap(double resolution = 0.05);

/** What outdoorMap() makes. */
struct OutdoorOptions
{
  double size = 200;        //!< side of the square that the map covers [m], 10 … 500
  double resolution = 0.2;  //!< size of a voxel [m], 0.05 … 1 and ≥ size/2500
  std::uint64_t seed = 1;   //!< other seeds give other landscapes

  /** \exception std::invalid_argument naming the option, its value and what would be right */
  void check() const;
};

/** A generated landscape as a ground scanner would have mapped it, centred on the origin: hills
 * (8 m of height difference on 200 m, less on less), houses with unknown inside, sheds and a
 * bridge (free under and above the roof), free-standing walls with an unknown shadow behind, trees
 * (free under the crown) and holes where nothing was seen. Free space reaches 3 to 12 m above the
 * ground, with a ragged end. About 7 million leaves with the defaults.
 *
 * Needs about 1 byte per voxel of the covered box while it works (0.12 GB with the defaults). The
 * same options give the same bits.
 *
 * \return a pruned tree with clamped values, as OctoMap reads it from a `.bt` file
 * \exception std::invalid_argument for bad options */
std::unique_ptr<octomap::OcTree> outdoorMap(const OutdoorOptions& options = {});

}  // namespace mrpt_mapconv::sim
