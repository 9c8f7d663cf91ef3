#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/params/Fields.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace mrpt_mapconv::eval
{
/** How an ElevationMap takes points; names and defaults are those of ANYbotics' elevation_mapping.
 */
struct ElevationMapParams
{
  double minVariance = 0.003 * 0.003;         //!< [m²]
  double maxVariance = 0.03 * 0.03;           //!< [m²]
  double mahalanobisDistanceThreshold = 2.5;  //!< infinite: each point is fused
  double multiHeightNoise = 0.003 * 0.003;    //!< [m²]

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    v("minVariance", p.minVariance, "m^2", "after a scan a cell has at least this variance");
    v("maxVariance", p.maxVariance, "m^2", "after a scan a cell with more variance is forgotten");
    v("mahalanobisDistanceThreshold", p.mahalanobisDistanceThreshold, "",
      "a point is fused if it is at most so many standard deviations of the cell's height from it");
    v("multiHeightNoise", p.multiHeightNoise, "m^2",
      "variance that a point which is not fused adds to a cell of earlier scans");
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;
};

/** A fused map: the height that is to be expected at a cell if its place is uncertain. */
struct FusedElevation
{
  grid::Layer<float> height;        //!< mean [m]; NaN: not known
  grid::Layer<float> lower, upper;  //!< 1 % and 99 % quantiles of the heights' 2σ bounds [m]
};

/** The baseline that TerrainMap is compared with: a height and a variance for each cell of a dense
 * grid, after Fankhauser et al. (2014, 2018) and what their node elevation_mapping does.
 *
 * Cells and variances of points are those of terrain::TerrainMap. A point within the Mahalanobis
 * distance of its cell's height is fused by a Kalman filter. One that is farther is left out if it
 * is below what this scan has fused, replaces it if it is above, and else adds to the variance.
 * Of its robot's motion a scan only tells that of z, roll and pitch, so the horizontal variances,
 * which the node has for each cell, are always its least ones, (resolution / 2)²; and scans are
 * told apart by their number, where the node has a duration.
 */
class ElevationMap
{
 public:
  /** An empty map. \param resolution [m]
   * \exception std::invalid_argument for one that is not valid, or parameters that are not */
  explicit ElevationMap(double resolution, const ElevationMapParams& params = {});

  double resolution() const { return m_known.resolution; }

  /** Updates the cells by the points of a scan, in their order.
   * \exception std::runtime_error naming the place if a point lies beyond the range of keys, or if
   * the grid would have more than 4e8 cells \exception std::invalid_argument as
   * terrain::TerrainMap::insert() */
  terrain::InsertedPoints insert(const terrain::TerrainScan& scan,
                                 const terrain::PointSigmas& sigmas);

  /** Fuses every known cell with its neighbours in the ellipse of its horizontal variances, each
   * weighted by the normal distribution's mass in it. \return what stays valid until the next call
   */
  const FusedElevation& fuse();

  /** The smallest frame that holds all cells with points. */
  const grid::GridFrame& frame() const { return m_known; }
  grid::Layer<float> height() const;    //!< [m]; NaN: not known
  grid::Layer<float> variance() const;  //!< [m²]; NaN: not known
  /** Bytes of heap that cells and the fused map have. */
  std::size_t memory() const;

  struct Cell
  {
    float height = 0;                                         //!< [m]
    float variance = std::numeric_limits<float>::infinity();  //!< [m²]; infinite: not known
    std::uint32_t scan = 0;  //!< number of the last one with a point here, times two;
                             //!< plus 1 if such a point was fused
  };

 private:
  void makeRoomFor(const grid::GridFrame& needed);
  template <class ValueOf>
  grid::Layer<float> layerOf(const ValueOf& valueOf) const;

  ElevationMapParams m_params;
  grid::GridFrame m_known;    //!< of the cells with points
  grid::Layer<Cell> m_cells;  //!< holds these, and some room around them
  std::uint32_t m_scan = 0;   //!< number of the last one
  FusedElevation m_fused;     //!< on m_known
};

}  // namespace mrpt_mapconv::eval
