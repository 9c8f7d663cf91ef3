#pragma once

#include <mrpt_mapconv/path/LiftPath.h>
#include <mrpt_mapconv/path/StepLimit.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mrpt_mapconv::path
{
/** Why a robot cannot go straight from one point of a lifted path to the next. */
struct PieceProblem
{
  enum class Kind : std::uint8_t
  {
    FloorStep,     //!< the supports below the two points differ too much for a ground robot
    HeightStep,    //!< so do the path's heights
    UnseenGround,  //!< a cell in between has a floor, but no support for a ground robot
    Occupied       //!< an occupied voxel is in the way; without a voxel map, what the layers show
  };
  Kind kind = Kind::Occupied;
  std::size_t index = 0;       //!< of the second of the two points
  mrpt::math::TPoint2D place;  //!< [m]
  double from = 0, to = 0;  //!< heights before and behind the step, or below and above what is in
                            //!< the way [m]; 0 for UnseenGround
  double distance = 0;      //!< between the two points, horizontally, as StepLimit counts it [m]
  double limit = 0;         //!< of the step [m]
  mrpt::math::TPoint3D shownOrigin = {0, 0, 0};  //!< LiftParams::shownOrigin

  std::string inWords() const;  //!< with place and heights, shownOrigin added
};

/** Checks the straight pieces between the points of a lifted path; liftPath() looks at the points.
 *
 * - Ground robots: neither Layers::support nor height changes by more than StepLimit from point to
 *   point, and no piece crosses a cell that has a floor, but no support.
 * - No piece crosses an occupied voxel (touching is no crossing). An aerial robot's is the piece
 *   itself; for a ground robot all counts that is above the piece, less heightOffset, by
 *   max(maxStep, one voxel) to minClearance. Unknown voxels are in nobody's way, also those
 *   between an inferred ground and the free range over it.
 * - Without a voxel map the layers stand for it: occupied cells without a floor at all heights,
 *   others below their floor (ground robots: their support) and, for aerial robots, above their
 *   ceiling.
 */
class PieceCheck
{
 public:
  /** \param layers, conversion, params, voxels as for liftPath(); they must outlive this */
  PieceCheck(const freespace::Layers& layers, const freespace::ConversionParams& conversion,
             const LiftParams& params, const voxel::VoxelSource* voxels);

  /** What is wrong with a path's pieces: its steps of the floor, then those of its heights, then
   * unseen ground, then what is in the way, each from the start on; of a piece the first of a kind.
   * Pieces that end in a point that cannot be reached are left out. */
  std::vector<PieceProblem> problems(const LiftedPath& path) const;

 private:
  void addSteps(const LiftedPath& path, PieceProblem::Kind kind,
                std::vector<PieceProblem>& found) const;
  void addUnseenGround(const LiftedPath& path, std::vector<PieceProblem>& found) const;
  void addCrossings(const LiftedPath& path, std::vector<PieceProblem>& found) const;

  const freespace::Layers& m_layers;
  double m_minClearance;
  const LiftParams& m_params;
  const voxel::VoxelSource* m_voxels;
  StepLimit m_limit;
};

}  // namespace mrpt_mapconv::path
