#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>

#include <cstdint>

namespace mrpt_mapconv::freespace
{
/** Finds drop edges: cells from whose support one comes, over open cells without support only and
 * within 1 m between centres, to a floor that lies lower than a step and a voxel. It may be that of
 * one of these cells, or of the first other cell after them. Heights are 64ths of a voxel. */
class DropWalk
{
 public:
  /** \param layers to look at; their frame has to stay */
  DropWalk(const ConversionParams& params, const Layers& layers);

  /** Whether there are such edges at all: with maxStep = 0, and where supports are floors, not. */
  bool isOn() const { return m_isOn; }
  /** How far floors may lie below a support. */
  std::int32_t most() const { return m_most; }
  /** How many cells it looks ahead along an axis of the grid. */
  std::int32_t reach() const { return m_straight; }

  /** Whether the walk from cell (ix, iy), counted in the frame, in one of 8 directions finds one.
   */
  bool leadsDown(std::int32_t ix, std::int32_t iy, std::int32_t dx, std::int32_t dy,
                 std::int32_t support) const;
  /** Whether any of the 8 does; false for a cell without support. */
  bool isEdge(std::int32_t ix, std::int32_t iy) const;

 private:
  const Layers& m_layers;
  bool m_isOn;
  std::int32_t m_most, m_straight, m_diagonal;
  double m_unitsPerMetre;
};

}  // namespace mrpt_mapconv::freespace
