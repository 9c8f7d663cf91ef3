#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/path/LiftPath.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "DenseMap.h"

namespace mrpt_mapconv::oracle
{
/** A cell's kept free range [m], in float as the layers hold heights. (Not doubles rounded to
 * float: GCC 12 leaves the rounding of two of them at once out when it vectorizes.) */
struct KeptRun
{
  float begin, end;
};

/** What one cell near a sphere demands of its centre's height. */
struct CellDemand
{
  std::vector<KeptRun> runs;  //!< one of them must hold the sphere; none: nothing can
  double halfHeight = 0;      //!< how far the sphere reaches up and down over the cell [m]
  double distance = 0;        //!< d [m]
  bool occupied = false;      //!< known to be no free space; only meaningful without runs
  mrpt::math::TPoint2D centre;
};

/** Lifting by its definition: all cells around each point, all candidate heights, no shortcuts. */
class LiftOracle
{
 public:
  /** \param voxels null: the layers alone say where a cell's single range is */
  LiftOracle(const freespace::Layers& layers, const freespace::ConversionParams& conversion,
             const path::LiftParams& params, const DenseMap* voxels);

  /** Heights for points that are already dense; z and what points had before is ignored. */
  std::vector<path::LiftedPoint> lift(const std::vector<path::LiftedPoint>& dense) const;
  /** The demands of all cells that a sphere at (x, y) reaches. */
  std::vector<CellDemand> demands(double x, double y) const;
  /** How much of a ground robot's way lies in cells whose ground is inferred [m]: each of its
   * pieces is cut with every such cell. */
  double inferredLength(const std::vector<path::LiftedPoint>& dense) const;
  /** Whether a cell lets a sphere be at height z, to 1e-5 m. */
  static bool satisfied(const CellDemand& demand, double z);

 private:
  std::optional<std::size_t> cellAt(double x, double y) const;
  float heightOf(std::size_t cell) const;
  double highestFloor(const std::vector<path::LiftedPoint>& dense, std::size_t index) const;
  void fitSphere(path::LiftedPoint& point) const;
  std::vector<KeptRun> runsOf(int kx, int ky) const;

  const freespace::Layers& m_layers;
  const freespace::ConversionParams& m_conversion;
  const path::LiftParams& m_params;
  const DenseMap* m_voxels;
};

}  // namespace mrpt_mapconv::oracle
