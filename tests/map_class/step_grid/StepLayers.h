#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/params/ListedOptions.h>
#include <mrpt_mapconv/voxel/ColumnSet.h>

#include <vector>

namespace step_grid
{
/** How a map of steps begins. */
struct StepGridParams
{
  double resolution = 0.10;  //!< size of a cell [m]

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    v("resolution", p.resolution, "m", "size of a cell");
  }
};

/** How a StepLayers tells steps. */
struct StepParams : mrpt_mapconv::params::ListedOptions<StepParams>
{
  static constexpr const char* kName = "StepParams";
  static constexpr const char* kStreamName = "step parameters";
  static constexpr std::uint8_t kStreamVersion = 0;

  double maxStep = 0.2;    //!< a cell whose points differ by more in height is occupied [m]
  double maxRange = 20.0;  //!< points further from the sensor are left out [m]

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    v("maxStep", p.maxStep, "m", "a cell whose points differ by more in height is occupied");
    v("maxRange", p.maxRange, "m", "points further from the sensor are left out");
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;
};

/** A made-up algorithm: per cell the lowest and the highest point that was ever seen, and from them
 * whether there is a step. All layers are on one frame, which grows as needed. */
struct StepLayers
{
  /** \param resolution of the cells [m] */
  explicit StepLayers(double resolution);

  /** Adds points, in the map frame [m].
   * \param maxStep see StepParams
   * \return the cells that got one
   * \exception std::runtime_error if that is too large a grid; the layers then stay as they were */
  mrpt_mapconv::voxel::ColumnSet insert(const std::vector<mrpt::math::TPoint3D>& points,
                                        double maxStep);

  mrpt_mapconv::grid::Layer<float> lowest, highest;  //!< [m]; NaN: nothing seen
  mrpt_mapconv::grid::Layer<float> occupancy;        //!< 0 free, 1 a step, −1 nothing seen

 private:
  void makeRoomFor(const mrpt_mapconv::grid::GridFrame& needed);
};

}  // namespace step_grid
