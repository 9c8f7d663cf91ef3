#pragma once

#include <mrpt_mapconv/sim/SampleMaps.h>

#include <cstdint>
#include <vector>

#include "VoxelCanvas.h"

namespace mrpt_mapconv::sim
{
/** Cells of a horizontal rectangle, both corners included. */
struct Area
{
  std::int32_t x0, y0, x1, y1;
};

/** The ground of an outdoor map and a canvas to build on it. Lengths are in voxels. */
class Landscape
{
 public:
  using State = VoxelCanvas::State;

  /** Hills, and the free space that a scanner saw above them. */
  explicit Landscape(const OutdoorOptions& options);

  VoxelCanvas& canvas() { return m_canvas; }
  std::int32_t cells(double metres) const;  //!< metres to the nearest number of voxels, ≥ 1
  const Area& area() const { return m_area; }
  bool inside(std::int32_t x, std::int32_t y) const
  {
    return x >= m_area.x0 && y >= m_area.y0 && x <= m_area.x1 && y <= m_area.y1;
  }
  /** Key of the lowest voxel above the ground; of the nearest cell inside for one outside. */
  std::int32_t ground(std::int32_t x, std::int32_t y) const;
  std::int32_t highestGround(const Area& area) const;

  /** A block that stands on the ground of each of its columns and ends at the key `top`. */
  void raise(const Area& area, std::int32_t top);
  /** What a scanner missed: unknown from `depth` voxels below the ground's face (0 keeps the
   * ground) up to the key `top`. */
  void hide(const Area& area, std::int32_t depth, std::int32_t top);

 private:
  void makeGround(const OutdoorOptions& options);
  void paintGroundAndAir(const OutdoorOptions& options);

  double m_resolution;
  Area m_area;
  std::int32_t m_relief;  //!< height difference of the ground
  VoxelCanvas m_canvas;
  std::vector<std::int32_t> m_ground;
};

}  // namespace mrpt_mapconv::sim
