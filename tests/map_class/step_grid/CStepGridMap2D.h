#pragma once

#include <mrpt_mapconv/maps/LayerGridMap2D.h>

#include "StepLayers.h"

namespace step_grid
{
/** A map that shows where 3D scans have found steps, see StepLayers. In an ini file:
 * \code
 * [map]
 * stepGrid_count = 1
 * [map_stepGrid_00_creationOpts]
 * resolution = 0.10            // [m] size of a cell
 * [map_stepGrid_00_insertOpts]
 * maxStep = 0.2                // see StepParams
 * [map_stepGrid_00_likelihoodOpts]
 * likelihoodMethod = lmLikelihoodField_Thrun   // see COccupancyGridMap2D::TLikelihoodOptions
 * \endcode
 */
class CStepGridMap2D : public mrpt_mapconv::maps::LayerGridMap2D
{
  DEFINE_SERIALIZABLE(CStepGridMap2D, step_grid)

 public:
  /** An empty map. \param resolution size of a cell, 0.0001 to 1000 m */
  explicit CStepGridMap2D(double resolution = StepGridParams().resolution);

  StepParams insertionParams;  //!< take effect with the next insertion

  std::vector<mrpt_mapconv::grid::StyledLayer> styledLayers() const override;

 protected:
  void internal_clear() override;
  const mrpt_mapconv::grid::Layer<float>& shownLayer() const override { return m_layers.occupancy; }
  void checkOptions() const override { insertionParams.check(); }
  std::string insertScan(const mrpt_mapconv::observation::SensorPoints& scan) override;

 private:
  StepLayers m_layers;

  MAP_DEFINITION_START(CStepGridMap2D)
  step_grid::StepGridParams creationOpts;
  step_grid::StepParams insertionOpts;
  mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions likelihoodOpts;
  mrpt_mapconv::observation::SayOnceLog said;  //!< by all maps made of it, e.g. one per particle
  MAP_DEFINITION_END(CStepGridMap2D)
};

}  // namespace step_grid
