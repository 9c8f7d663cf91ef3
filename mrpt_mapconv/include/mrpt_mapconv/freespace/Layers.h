#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <array>
#include <limits>
#include <string>
#include <utility>

namespace mrpt_mapconv::freespace
{
/** The five layers of a converted voxel map, all on one frame. */
struct Layers
{
  grid::Layer<float> floor;    //!< bottom face of the lowest kept free range [m]; NaN: none kept
  grid::Layer<float> ceiling;  //!< top face of the highest kept free range [m]; NaN: none kept
  grid::Layer<float> slope;    //!< slope of the floor [m/m]; NaN: no floor or no plane
  grid::Layer<float> aerial;  //!< occupancy for a flying robot: 0 free, (0,1] occupied, −1 unknown
  grid::Layer<float> ground;  //!< occupancy for a ground robot: likewise

  Layers() = default;
  /** All unknown. */
  explicit Layers(const grid::GridFrame& frame)
      : floor(frame, kNone),
        ceiling(frame, kNone),
        slope(frame, kNone),
        aerial(frame, grid::kUnknown),
        ground(frame, grid::kUnknown)
  {
  }

  const grid::GridFrame& frame() const { return floor.frame(); }
  /** The layers laid on another frame; cells that were not there before are unknown. */
  Layers onFrame(const grid::GridFrame& frame) const;

  /** Names and layers in the order of export. */
  std::array<std::pair<std::string, const grid::Layer<float>*>, 5> named() const
  {
    return {{{"floor", &floor},
             {"ceiling", &ceiling},
             {"slope", &slope},
             {"aerial", &aerial},
             {"ground", &ground}}};
  }

  static constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
};

/** Counts over the layers. */
struct LayerStatistics
{
  std::size_t free = 0;          //!< aerial cells with a kept free range
  std::size_t occupied = 0;      //!< aerial cells that are occupied
  std::size_t unknown = 0;       //!< aerial cells of which nothing is known
  std::size_t steep = 0;         //!< free in the aerial but occupied in the ground layer
  std::size_t slopeUnknown = 0;  //!< free cells whose slope could not be fitted
};
LayerStatistics statistics(const Layers& layers);

}  // namespace mrpt_mapconv::freespace
