#pragma once

#include <mrpt/math/CMatrixFixed.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/terrain/TerrainParams.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace mrpt_mapconv::terrain
{
/** A scan and how sure its robot was of its pose. */
struct TerrainScan
{
  /** Coordinates of the points in the sensor's frame [m], `points` of each; the array of one point
   * may lie between those of another, see `stride`. */
  const float *x = nullptr, *y = nullptr, *z = nullptr;
  std::size_t points = 0;
  std::size_t stride = 1;           //!< floats from one point to the next
  mrpt::poses::CPose3D sensorPose;  //!< sensor -> map
  mrpt::poses::CPose3D robotPose;   //!< robot -> map
  /** Covariance of the robot's z [m], roll and pitch [rad], in this order. */
  mrpt::math::CMatrixDouble33 poseCovariance;
};

/** What became of a scan's points. */
struct InsertedPoints
{
  std::size_t inserted = 0;
  std::size_t notFinite = 0;  //!< NaN or infinite: left out
  std::size_t outside = 0;    //!< of the local window: left out
};

/** A cell, as it is known from the points in it. */
struct TerrainCell
{
  std::uint64_t points = 0;
  double height = 0;    //!< by the rule [m]
  double variance = 0;  //!< of it: 1/Σ(1/σ²), or that of the highest point [m²]
};

/** A plane of a map. */
struct TerrainPlane
{
  std::int64_t cells = 0;
  double slopeX = 0, slopeY = 0;  //!< [m/m]
  double x = 0, y = 0, z = 0;     //!< where its cells are on average, and its height there [m]
  double rms = 0;                 //!< of its cells' vertical differences to it [m]
  double xMin = 0, yMin = 0, xMax = 0, yMax = 0;  //!< the rectangle that holds its cells [m]
  std::int32_t firstX = 0, firstY = 0;            //!< key of its first cell, row by row

  double slope() const;  //!< steepest rise [m/m]
  double heightAt(double px, double py) const { return z + slopeX * (px - x) + slopeY * (py - y); }
};

/** A square of cells that are stored as one. */
struct TerrainLeaf
{
  std::int32_t x = 0, y = 0;  //!< key of its lower corner, divisible by `side`
  std::int32_t side = 1;      //!< [cells], a power of two
  std::int32_t plane = -1;    //!< index in TerrainMap::planes(); −1: none, its height is its own
  double height = 0;          //!< at its centre [m]
};

/** What is known of a place. */
struct TerrainPoint
{
  double height = 0;  //!< of the plane there, or of the cell [m]
  mrpt::math::TPoint3D normal{0, 0,
                              1};  //!< of the plane, upwards, of length 1; of a cell (0, 0, 1)
  std::int32_t plane = -1;         //!< index in TerrainMap::planes(); −1: none
  std::int32_t leafSide = 1;       //!< [cells]
};

/** A step between two neighbouring planes. */
struct TerrainStep
{
  std::int32_t lower = -1, upper = -1;    //!< planes
  double height = 0;                      //!< from the one's inner cells to the other's [m]
  double depth = 0;                       //!< of the upper plane in the direction of the step [m]
  double width = 0;                       //!< along which they meet [m]
  double x = 0, y = 0;                    //!< middle of where they meet [m]
  double directionX = 0, directionY = 0;  //!< upwards, of length 1
};

/** Layers of a map on one frame, whose cells are centred on multiples of the resolution. */
struct TerrainLayers
{
  grid::Layer<float> height;          //!< [m]; NaN: not known
  grid::Layer<float> sigma;           //!< of a plane its rms, else of the cell's height [m]
  grid::Layer<float> plane;           //!< its index; NaN: none
  grid::Layer<float> leafSide;        //!< [m]; NaN: not known
  grid::Layer<float> slope;           //!< of the plane [m/m]; NaN: no plane
  grid::Layer<float> traversability;  //!< 0 free, 1 occupied, −1 not known
};

/** An adaptive-resolution map of terrain (Zhou et al. 2023).
 *
 * A 2D grid of cells with key floor(x/L + 0.5), each with a height and its variance; planes that
 * cells lie on; and leaves, squares of 2^k cells that lie in one plane. Cells know their points as
 * whole numbers, so neither they nor what a full extraction makes of them depends on the order in
 * which points come.
 *
 * Cells are changed by insert(); planes and leaves follow at update(), and only where cells have
 * changed. What asks for planes or leaves is right after an update.
 */
class TerrainMap
{
 public:
  /** An empty map. \param resolution L [m]
   * \exception std::invalid_argument for one that is not valid, or parameters that are not */
  explicit TerrainMap(double resolution, const TerrainParams& params = {});
  ~TerrainMap();
  TerrainMap(const TerrainMap& o);
  TerrainMap& operator=(const TerrainMap& o);
  TerrainMap(TerrainMap&&) noexcept;
  TerrainMap& operator=(TerrainMap&&) noexcept;

  double resolution() const;
  const TerrainParams& params() const;

  /** Adds the points of a scan to their cells. With a local window, which is moved to the robot
   * first, cells that it leaves are forgotten, also by planes().
   * \exception std::runtime_error naming the place, and the map as it was, if a point lies beyond
   * 2^30 cells \exception std::invalid_argument for a pose that is not finite, or sigmas that are
   * not valid */
  InsertedPoints insert(const TerrainScan& scan, const PointSigmas& sigmas);
  /** Adds a point. \param sigma of its height [m] \exception std::runtime_error as insert() */
  void insertPoint(double x, double y, double z, double sigma);

  /** Has planes and leaves follow the cells that have changed.
   * \param threads 0 = all cores; the result is the same for any number */
  void update(int threads = 0);
  /** Forgets planes and leaves and makes them anew of all cells. */
  void extract(int threads = 0);
  void clear();

  // --- cells
  std::size_t cells() const;
  /** The frame of all known cells. */
  grid::GridFrame frame() const;
  std::optional<TerrainCell> cell(std::int32_t kx, std::int32_t ky) const;
  /** The key of the cell that holds a coordinate: floor(x/L + 0.5). Of NaN, and of what is beyond
   * numbers, the lowest one, which no cell has. */
  std::int32_t keyOf(double x) const;

  // --- planes and leaves
  /** By the order of their first cells, row by row. */
  const std::vector<TerrainPlane>& planes() const;
  std::size_t leaves() const;
  std::optional<TerrainPoint> at(double x, double y) const;
  /** The leaves that reach into a rectangle [m], in the order of the quadtree. */
  std::vector<TerrainLeaf> leavesIn(double xMin, double yMin, double xMax, double yMax) const;
  /** Steps between neighbouring planes that differ in height by more than planeTolerance where they
   * meet, ordered by their planes. Planes that meet all around, as a platform and its floor, have
   * one for each side. */
  std::vector<TerrainStep> steps() const;

  /** All layers on a frame that holds frame(). What is traversable keeps to the safe side: steps
   * and slopes are occupied, cells with a point more than maxStep above their height, and the edges
   * of drops whose foot nobody saw. */
  TerrainLayers layers() const;

  /** Writes cells, planes and leaves, but not the parameters, such that the map that reads them
   * goes on as this one does. */
  void save(mrpt::serialization::CArchive& out) const;
  /** Becomes the map that was written, of its resolution; the parameters stay.
   * \exception std::exception for a stream that ends or holds no such map; this one then stays as
   * it was */
  void load(mrpt::serialization::CArchive& in);

  /** Bytes of heap that cells, planes and leaves have. */
  std::size_t memory() const;

 private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

}  // namespace mrpt_mapconv::terrain
