#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/params/Fields.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelGrid.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace mrpt_mapconv::voxel
{
/** What a ray says of the voxel in which it ends. */
enum class RayEnd : std::uint8_t
{
  Hit,    //!< something returned from there
  Clear,  //!< nothing did: free, as all before it
  Keep    //!< nothing is known of it
};

/** A line of sight, in the map's frame [m]. */
struct Ray
{
  mrpt::math::TPoint3D origin, end;
  RayEnd atEnd = RayEnd::Hit;
};

/** How rays change a VoxelGrid; defaults are those of OHM's occupancy mapping, as Carvalho de Lima
 * et al. (RA-L 2024, section IV-B) use it. */
struct RayParams
{
  double probHit = 0.9;       //!< probability that stands for a hit
  double probMiss = 0.45;     //!< probability that stands for a miss
  double minLogOdds = -2.0;   //!< lowest log-odds of a voxel
  double maxLogOdds = 3.511;  //!< highest log-odds of a voxel
  double maxRange = -1;       //!< longest part of a ray that is inserted [m]; −1: all of it
  std::optional<std::int32_t> maxMemory;  //!< of the voxel map [MB]; none: 3/4 of the machine's

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    v("probHit", p.probHit, "", "probability that stands for a hit, 0.5 to 1");
    v("probMiss", p.probMiss, "", "probability that stands for a miss, below 0.5");
    v("minLogOdds", p.minLogOdds, "", "lowest log-odds of a voxel");
    v("maxLogOdds", p.maxLogOdds, "", "highest log-odds of a voxel");
    v("maxRange", p.maxRange, "m", "longest part of a ray that is inserted; -1 = all of it");
    v("maxMemory", p.maxMemory, "MB",
      "largest voxel map; auto = three quarters of the machine's memory");
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right; also
   * for values that exclude each other */
  void check() const;
};

/** The same sensor model, range and limit as those of insertScan(). */
RayParams rayParamsOf(const TVoxelInsertionOptions& options);

/** What insertRays() did. */
struct InsertedRays
{
  std::size_t rays = 0;       //!< that were inserted
  std::size_t notFinite = 0;  //!< that were skipped since a coordinate is NaN or infinite
  std::size_t updates = 0;    //!< of voxels, several of one voxel counted each
  ColumnSet columns;          //!< all columns of the bricks that rays went through
};

/** Inserts rays: each voxel on the way gets a miss, that of the ray's start included; then the
 * voxel of its end gets what the ray says. A ray that ends in the voxel in which it starts says
 * nothing but that. Log-odds are added and clamped to [minLogOdds, maxLogOdds] after every update,
 * and never locked.
 *
 * Rays longer than maxRange are cut there, and end in a miss. Ends are snapped to 1/256 voxel; from
 * there on the walk is exact (walkRay()). A voxel that several rays go through is updated several
 * times.
 *
 * The result is that of the rays one after the other, as they are numbered, for any number of
 * threads: each of them has a slab of the map to itself, and takes the rays' parts there in order.
 * \param threads 0: all cores
 * \exception std::invalid_argument for parameters that are not valid
 * \exception std::out_of_range for a ray that leaves the range of ±2^31 voxels
 * \exception std::runtime_error if the map would exceed maxMemory; says by how much
 * In all cases the map is as it was. */
InsertedRays insertRays(VoxelGrid& grid, const std::vector<Ray>& rays, const RayParams& params = {},
                        int threads = 0);

}  // namespace mrpt_mapconv::voxel
