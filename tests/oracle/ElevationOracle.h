#pragma once

#include <mrpt_mapconv/eval/ElevationMap.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace mrpt_mapconv::oracle
{
/** eval::ElevationMap, one point after the other in double precision, as the formulas say it. */
class SlowElevationMap
{
 public:
  struct Cell
  {
    double height = 0, variance = 0;
    bool fusedByThisScan = false;
  };

  SlowElevationMap(double resolution, const eval::ElevationMapParams& params)
      : m_resolution(resolution), m_params(params)
  {
  }
  void insert(const terrain::TerrainScan& scan, const terrain::PointSigmas& sigmas);

  std::map<std::pair<int, int>, Cell> cells;  //!< by their keys

 private:
  int keyOf(double metres) const;
  void update(int kx, int ky, double z, double variance);

  const double m_resolution;
  const eval::ElevationMapParams m_params;
};

/** A cell fused with the known ones around it. */
class SlowFusion
{
 public:
  SlowFusion(const grid::Layer<float>& heights, const grid::Layer<float>& variances,
             std::int32_t ix, std::int32_t iy);

  double mean() const { return m_sum / m_weights; }
  double lower() const { return quantile(m_lower, 0.01); }
  double upper() const { return quantile(m_upper, 0.99); }

 private:
  using Weighted = std::vector<std::pair<double, double>>;  //!< values and weights
  double quantile(Weighted values, double probability) const;

  double m_weights = 0, m_sum = 0;
  Weighted m_lower, m_upper;
};

}  // namespace mrpt_mapconv::oracle
