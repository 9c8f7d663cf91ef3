#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/freespace/OpenColumns.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <cstdint>
#include <optional>

namespace mrpt_mapconv::freespace
{
/** The frame of a voxel map: the xy bounding box, in keys, of all known voxels.
 * \exception std::runtime_error if no voxel is known, or if that is more than 4·10^8 cells */
grid::GridFrame frameOf(const voxel::VoxelSource& source);

/** \exception std::runtime_error for a frame of more than 4·10^8 cells (11 GB of layers) */
void checkFrameSize(const grid::GridFrame& frame);

/** A frame that holds both; on each side where `needed` made `frame` grow it gets half its size
 * more, unless that is too large, so that growing step by step stays rare.
 * \exception std::runtime_error as checkFrameSize() */
grid::GridFrame grownFrame(const grid::GridFrame& frame, const grid::GridFrame& needed);

/** Converts a whole voxel map by free-space projection (Fredriksson et al. 2024, eqs. 1–8).
 *
 * \param source the voxel map; params.reading says how it is read
 * \param params checked first
 * \param threads number of threads; 0 = all cores
 * \return the layers on frameOf(source); all unknown if no free range is kept
 * \exception std::invalid_argument for bad parameters
 * \exception std::runtime_error for a map without any known voxel or of more than 4·10^8 cells */
Layers convert(const voxel::VoxelSource& source, const ConversionParams& params, int threads = 0);

/** What an update may have changed. */
struct LayersChange
{
  bool everywhere = false;   //!< all of the layers; else only
  voxel::ColumnSet columns;  //!< these columns
};

/** Layers that follow a voxel map while it changes.
 *
 * update() touches only the changed columns and what depends on them (occupancy: 1 cell around,
 * slope: S_A around, inferred support: as far as the next seen cells) and gives the same bits as a
 * full conversion on the same frame. The frame grows by half its size when a column lies outside,
 * so that laying out anew stays rare; exact() gives the layers on the map's exact bounding box.
 */
class IncrementalLayers
{
 public:
  /** \exception std::invalid_argument for bad parameters */
  explicit IncrementalLayers(const ConversionParams& params = {}, int threads = 0);

  const ConversionParams& params() const { return m_params; }
  /** Layers on the present frame, which holds every known voxel and some room around. */
  const Layers& layers() const { return m_layers; }
  /** Layers on the source's bounding box; empty layers if no voxel is known. */
  Layers exact(const voxel::VoxelSource& source) const;

  /** Converts everything anew on the source's bounding box; an empty map gives empty layers. */
  void rebuild(const voxel::VoxelSource& source);
  /** Converts everything anew on the given frame, which must hold every known voxel. */
  void rebuild(const voxel::VoxelSource& source, const grid::GridFrame& frame);
  /** Follows a change of the source in the columns `changed` (a superset is fine). Should it throw
   * half way, the next update converts everything anew.
   * \return what may have changed: everywhere, if the frame did or the height up to which unknown
   * voxels are free */
  LayersChange update(const voxel::VoxelSource& source, const voxel::ColumnSet& changed);
  /** Forgets everything: empty layers. */
  void clear();

 private:
  voxel::ColumnSet follow(const voxel::VoxelSource& source, const voxel::ColumnSet& changed);

  void rebuildFilled(const voxel::FilledSource& source, const grid::GridFrame& frame);

  ConversionParams m_params;
  int m_threads;
  Layers m_layers;
  OpenColumns m_open;                      //!< of m_layers, with floorFrom = seen
  std::optional<std::int32_t> m_freeUpTo;  //!< that m_layers were made with
  bool m_unfinished = false;  //!< an update was broken off: the layers hold some of a change
};

}  // namespace mrpt_mapconv::freespace
