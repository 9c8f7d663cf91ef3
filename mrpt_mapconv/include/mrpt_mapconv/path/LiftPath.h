#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/freespace/Robot.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mrpt_mapconv::path
{
/** How a 2D path is given heights. */
struct LiftParams
{
  freespace::Robot robot = freespace::Robot::Aerial;
  double lookahead = 0.5;     //!< the floor (for a ground robot: the ground) is looked at this far
                              //!< ahead and behind, along the path [m]
  double heightOffset = 0.5;  //!< R_off: height above that floor or ground [m]
  double safetyRadius = 0.3;  //!< R_r: of the aerial robot's sphere, (0, minClearance/2] [m]
  bool unknownIsPassable = false;  //!< cells of which nothing is known do not stop the sphere
  /** Of the layers' frame; messages tell places with it (grid::GeoReference::origin) [m]. */
  mrpt::math::TPoint3D shownOrigin = {0, 0, 0};

  /** \param minClearance R_maxZ that the layers were made with [m]
   * \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check(double minClearance) const;
};

/** What decided the height of a point. */
enum class HeightRule : std::uint8_t
{
  None,           //!< nothing: the point has no height, see Infeasibility
  FloorAhead,     //!< the highest floor or ground within lookahead, plus heightOffset
  SphereFloor,    //!< raised until the sphere is clear of a floor
  SphereCeiling,  //!< lowered until the sphere is clear of a ceiling
  SphereSlab      //!< moved up or down, clear of a slab between two free ranges
};

/** Why a point cannot be reached. */
enum class Infeasibility : std::uint8_t
{
  None,
  OffMap,        //!< outside the layers
  NoFloor,       //!< its own cell has no floor
  UnseenGround,  //!< of a ground robot: its own cell has a floor, but no support
  Wall,          //!< the sphere reaches an occupied cell
  Unknown,       //!< the sphere reaches a cell of which nothing is known, or the map's edge
  NoHeight       //!< the sphere fits in at no height
};

/** A point of a lifted path. */
struct LiftedPoint
{
  mrpt::math::TPoint3D position;  //!< [m]; z is NaN if the point cannot be reached
  HeightRule rule = HeightRule::None;
  Infeasibility problem = Infeasibility::None;
  mrpt::math::TPoint2D obstacle;  //!< centre of the nearest cell in the way: Wall, Unknown [m]
  bool isInput = false;           //!< false for points that densifying added
};

/** A 2D path with heights. */
struct LiftedPath
{
  std::vector<LiftedPoint> points;
  bool slabsChecked = false;  //!< true if the voxel map was looked at, not the layers alone
  /** Of a ground robot's path: how much of length2D() lies in cells whose ground is inferred, not
   * seen (evidence::kInferred); the parts of its pieces in these cells are added up [m]. */
  double inferredLength = 0;
  mrpt::math::TPoint3D shownOrigin = {0, 0, 0};  //!< LiftParams::shownOrigin

  /** Index of the first point that cannot be reached; nothing if there is none. */
  std::optional<std::size_t> firstProblem() const;
  bool feasible() const { return !firstProblem(); }
  double length() const;    //!< over all points [m]; NaN if one cannot be reached
  double length2D() const;  //!< the same without the heights [m]
  /** Why a point cannot be reached, in words with its index and place, shownOrigin added; empty if
   * it can be. */
  std::string describeProblem(std::size_t index) const;
};

/** Gives a 2D path heights (Fredriksson et al. 2024, eq. 9).
 *
 * 1. The path is densified: its points are kept (repeated ones too), and between them points are
 *    added until no spacing exceeds a cell (by more than 1e-9 of it).
 * 2. p_f = the highest floor below the path's points within `lookahead` of arc length before and
 *    behind, ends included (to 1e-9 of a cell); cells without a floor and points off the map are
 *    skipped. z = p_f + heightOffset. For a ground robot the floor is Layers::support, on which it
 *    stands: of an open cell the layer floor is no more than an upper bound of the ground.
 * 3. Aerial robots only: with d the horizontal distance from the point to the nearest point of a
 *    cell's square, every cell with d ≤ R_r (to 1e-9 of a cell) must satisfy
 *    floor + sqrt(R_r² − d²) ≤ z ≤ ceiling − sqrt(R_r² − d²);
 *    with a voxel map, one single kept run [begin, end] of the cell must hold
 *    [z − sqrt(R_r² − d²), z + sqrt(R_r² − d²)]. If z violates one, the nearest z that satisfies
 *    all is taken, whatever heightOffset says; of two as near, the higher one.
 *    A cell without a kept run makes the point infeasible; with unknownIsPassable only one that is
 *    occupied (aerial layer > 0) does.
 *
 * Heights are taken as the layers hold them, in float, also a run's ends. A height that violates a
 * condition by 1e-5 m or less satisfies it, and differences of up to 1e-5 m count as equally near.
 * What lies between two points is left to PieceCheck.
 *
 * Points that cannot be reached say why (of several reasons the first in Infeasibility's order); no
 * other point depends on that.
 *
 * \param path [m]; may be empty or hold a single point
 * \param layers as convert() made them with `conversion`
 * \param voxels the voxel map that the layers were made of, or null: then slabs between two free
 * ranges of a column (a roof over a wall, a lintel) are not seen
 * \exception std::invalid_argument for bad parameters, a point that is not finite (with its
 * index), a path that would get more than 10 million points, layers that are empty or not on one
 * frame, or a voxel map that the layers were not made of */
LiftedPath liftPath(const std::vector<mrpt::math::TPoint2D>& path, const freespace::Layers& layers,
                    const freespace::ConversionParams& conversion, const LiftParams& params,
                    const voxel::VoxelSource* voxels = nullptr);

}  // namespace mrpt_mapconv::path
