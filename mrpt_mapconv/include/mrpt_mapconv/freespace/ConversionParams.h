#pragma once

#include <mrpt_mapconv/params/Fields.h>
#include <mrpt_mapconv/voxel/UnknownVoxels.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mrpt_mapconv::freespace
{
/** What the ground of a cell is taken from. */
enum class FloorFrom : std::uint8_t
{
  LowestFree,  //!< the bottom of the lowest kept free range, as the paper does
  Seen         //!< that, if the voxel under it is occupied; else seen cells around, see maxGap
};

/** How files call them, in the order of the enumeration. */
inline const std::vector<std::string>& namesOf(FloorFrom)
{
  static const std::vector<std::string> names{"lowestFree", "seen"};
  return names;
}

/** Parameters of the free-space projection. The defaults are Table I of Fredriksson et al. 2024,
 * but for what makes a map safe for a ground robot: steps are looked at, and the ground is where it
 * was seen; see takeNamedSet(). */
struct ConversionParams
{
  double minClearance = 1.0;  //!< R_maxZ: a free range must be at least this high [m]
  double minOccupancy =
      0.5;  //!< O_min: least share of a neighbour's free range that blocks, [0, 1]
  std::int32_t slopeWindow = 2;  //!< S_A: half side of the slope's window [cells], 1 … 100
  double maxSlope = 2.0;         //!< R_MS: a ground robot's steepest slope [m/m]
  /** Highest step between 8-neighbours for a ground robot [m]; none = auto, max(0.2 m, one voxel);
   * 0 = off. */
  std::optional<double> maxStep = {};
  voxel::ReadingParams reading = {};      //!< how the voxel map is read
  FloorFrom floorFrom = FloorFrom::Seen;  //!< what slopes, steps and Layers::support are of
  /** Longest gap between two seen cells over which the ground is inferred [m], with `floorFrom =
   * seen`. Let h be maxStepVoxels(). Of an open cell (see evidence::kOpen) the nearest seen cells
   * on either side are taken, on each of four axes, no wall between. The line between their
   * supports counts if (a) these differ by at most h; (b) at the cell it is at most one voxel above
   * the cell's floor, or max(h, one voxel) where the gap is at most maxHiddenGap; (c) the gap, from
   * centre to centre, is at most maxGap, and, but where floor ≤ line + h, since nothing higher than
   * a step can hide under free space that low, at most maxHiddenGap; (d) no open cell between has a
   * floor more than max(h, two voxels) below the line; (e) in the cell's column nothing is known
   * that is in the robot's way: under the floor nothing occupied has its top more than h (one
   * voxel, if maxStep is 0) above the line, over it none begins less than minClearance above the
   * line. The smallest gap counts, then the lower line, rounded to 1/64 voxel, halves up. */
  double maxGap = 6.0;
  double maxHiddenGap = 1.0;  //!< the same where something may hide in the gap [m]

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    using params::flag;
    v("minClearance", p.minClearance, "m", "a free range must be at least this high", flag("M"));
    v("minOccupancy", p.minOccupancy, "",
      "least share of a neighbour's free range that blocks, 0 to 1", flag("P"));
    v("slopeWindow", p.slopeWindow, "cells",
      "half side of the window over which a cell's slope is fitted", flag("N"));
    v("maxSlope", p.maxSlope, "m/m", "steepest slope for a ground robot", flag("S"));
    v("maxStep", p.maxStep, "m",
      "highest step for a ground robot; auto = 0.2 m, but a voxel at least; 0 = neither steps nor "
      "edges of drops are looked for",
      flag("M"));
    voxel::ReadingParams::visit(p.reading, v);
    v("floorFrom", p.floorFrom, "",
      "where the ground is: lowestFree = bottom of the lowest free range, seen = only where it was "
      "seen or is inferred from what was seen around",
      flag("F").since(1));
    v("maxGap", p.maxGap, "m",
      "longest gap between seen ground over which it is inferred, with floorFrom = seen",
      params::since(1));
    v("maxHiddenGap", p.maxHiddenGap, "m",
      "the same where free space begins more than a step above, so that something may hide under "
      "it",
      params::since(1));
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;

  static constexpr const char* kNamedSet = "paper";
  static constexpr const char* kNamedSetMeaning =
      "the conversion of Fredriksson et al. 2024 with its Table I: no steps are looked for and the "
      "lowest free voxel is the floor, so fences and drops may count as free";
  /** Takes the values of that paper; `reading` and the gaps, which it does not have, stay. */
  void takeNamedSet();
  /** The parameters of that paper. */
  static ConversionParams paper();
  /** What a stream or file means that does not say all of them, since it is older. */
  static ConversionParams ofOlderFiles();

  /** Voxels that a free range needs: max(1, ceil(minClearance/res − 1e-6)). */
  std::int32_t minRunVoxels(double resolution) const;
  /** Whether steps and drop edges are looked for: unless maxStep = 0. */
  bool looksForSteps() const { return !maxStep || *maxStep > 0; }
  /** What is no step [m]: maxStep, or max(0.2 m, one voxel) where that is auto or off. */
  double stepHeight(double resolution) const;
  /** The same in whole voxels. */
  std::int32_t maxStepVoxels(double resolution) const;
  /** Height of the lowest straight step that the slope test marks: maxSlope·res·(2·S_A+1)/1.5 [m].
   * Averaging over the window hides lower ones; maxStep finds them. */
  double minStep(double resolution) const;
  /** Height of the lowest straight wall, one cell thick, around which the slope test marks cells:
   * ((S_A+1)(2·S_A+1)/3)·maxSlope·res [m]. They lie S_A cells away from it on either side: on the
   * wall the slope is 0, and a single post is marked at 2·S_A+1 times that height only. */
  double minThinWall(double resolution) const;
};

}  // namespace mrpt_mapconv::freespace
