#pragma once

#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/grid/StyledLayer.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace mrpt_mapconv::freespace
{
/** The layers of a converted voxel map, all on one frame. */
struct Layers
{
  grid::Layer<float> floor;    //!< bottom face of the lowest kept free range [m]; NaN: none kept
  grid::Layer<float> ceiling;  //!< top face of the highest kept free range [m]; NaN: none kept
  grid::Layer<float> slope;    //!< slope of the ground [m/m]; NaN: no support or no plane
  grid::Layer<float> aerial;  //!< occupancy for a flying robot: 0 free, (0,1] occupied, −1 unknown
  grid::Layer<float> ground;    //!< occupancy for a ground robot: likewise
  grid::Layer<float> support;   //!< height of the ground [m]; NaN: none is known of
  grid::Layer<float> evidence;  //!< what is known of the ground, see Evidence.h

  /** A layer and what is said of it, see grid::StyledLayer. */
  struct Entry
  {
    grid::Layer<float> Layers::*member;
    const char *name, *title, *unit;
    grid::LayerKind kind;
    grid::Layer<float> Layers::*freeFor = nullptr, Layers::*evidence = nullptr;

    /** Whether it came with the evidence of the ground: files of earlier versions lack it. */
    bool isOfGround() const { return member == &Layers::support || member == &Layers::evidence; }
  };
  /** All layers in the order of export: whatever is done for each of them goes through this list.
   */
  static const std::vector<Entry>& list();

  Layers() = default;
  /** All unknown. */
  explicit Layers(const grid::GridFrame& frame);

  const grid::GridFrame& frame() const { return floor.frame(); }
  /** The layers laid on another frame; cells that were not there before are unknown. */
  Layers onFrame(const grid::GridFrame& frame) const;

  /** The layers as files, pictures and views show them; valid as long as this object. */
  std::vector<grid::StyledLayer> styled() const;
  /** The same, with drop edges marked. \param edges see dropEdges() */
  std::vector<grid::StyledLayer> styled(const grid::Layer<float>& edges) const;
  /** One of them. \exception std::invalid_argument if there is none of that name */
  grid::StyledLayer styled(const std::string& name) const;
  /** Only names and layers. */
  std::vector<std::pair<std::string, const grid::Layer<float>*>> named() const;

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
  std::size_t groundFree = 0, groundOccupied = 0, groundUnknown = 0;  //!< ground cells likewise
  std::size_t frontier = 0;  //!< free cells whose ground nobody has seen and nothing tells
  std::size_t inferred = 0;  //!< free cells whose ground is inferred from cells around
};
LayerStatistics statistics(const Layers& layers);

}  // namespace mrpt_mapconv::freespace
