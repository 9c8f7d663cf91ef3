#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/freespace/OpenColumns.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>

#include <cstdint>
#include <vector>

#include "SupportRules.h"

namespace mrpt_mapconv::freespace
{
/** Finds where the ground of open cells lies, from the seen cells around: support and evidence.
 *
 * On each of four axes an open cell lies between the nearest seen cells on either side, if no wall
 * is between. All open cells of such a segment share its line, so a sweep over the rows, which
 * remembers the last seen cell of every row, column and diagonal, meets each segment once: at its
 * upper end. It looks at heights, evidence and open columns only, never at voxels. */
class SupportPass
{
 public:
  /** \param open of the layers */
  SupportPass(const ConversionParams& params, const OpenColumns& open, Layers& layers);

  /** Finds the support of all open cells. The layers hold the seen cells' already, and no open
   * cell's. */
  void findAll(int threads);

  /** Finds it anew for the open cells whose support may have changed with the heights or the
   * evidence of some cells, whose own is as findAll() needs it.
   * \return those cells and the ones whose support or evidence differs from before */
  voxel::ColumnSet findAround(const voxel::ColumnSet& changed);

 private:
  /** A part of the frame, counted in its cells. */
  struct Window
  {
    std::int32_t x0, y0, width, height;

    std::size_t index(std::int32_t ix, std::int32_t iy) const
    {
      return static_cast<std::size_t>(iy - y0) * static_cast<std::size_t>(width) +
             static_cast<std::size_t>(ix - x0);
    }
    bool contains(std::int32_t ix, std::int32_t iy) const
    {
      return ix >= x0 && iy >= y0 && ix < x0 + width && iy < y0 + height;
    }
  };
  /** What the offers of a sweep go to. */
  struct Offers;

  void sweep(const Window& window, Offers& offers) const;
  void offer(const SupportLine& line, Offers& offers) const;
  template <class Visit>
  bool forEachOpen(const SupportLine& line, const Visit& visit) const;
  bool isGround(const SupportLine& line) const;
  bool isBlocked(const SupportLine& line, std::int32_t k, std::int32_t floor) const;
  float heightAt(const SupportLine& line, std::int32_t k) const;
  std::int32_t stepsToSeen(std::int32_t ix, std::int32_t iy, std::int32_t dx,
                           std::int32_t dy) const;
  float supportOf(std::int32_t ix, std::int32_t iy) const;
  void addAround(std::int32_t kx, std::int32_t ky, const voxel::ColumnSet& changed,
                 voxel::ColumnSet& open) const;

  const OpenColumns& m_open;
  Layers& m_layers;
  SupportRules m_rules;
};

}  // namespace mrpt_mapconv::freespace
