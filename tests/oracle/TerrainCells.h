#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <cstddef>
#include <cstdint>
#include <map>

#include "TerrainOracle.h"

namespace mrpt_mapconv::oracle
{
/** σ_h² of a point of a scan [m²], all derivatives by finite differences of composed poses. */
double heightVariance(const terrain::TerrainScan& scan, std::size_t point,
                      const terrain::PointSigmas& sigmas);

/** Points in cells, each point on its own and in floating point. */
class TerrainCells
{
 public:
  struct Cell
  {
    std::uint64_t points = 0;
    double weight = 0, weightedHeight = 0;    //!< Σ 1/σ², Σ z/σ²
    double highest = 0, highestVariance = 0;  //!< of the highest point, of those the surest
    double lowest = 0;
    double fused() const { return weightedHeight / weight; }
  };

  explicit TerrainCells(double resolution) : m_resolution(resolution) {}
  void insert(const terrain::TerrainScan& scan, const terrain::PointSigmas& sigmas);
  const std::map<TerrainKey, Cell>& cells() const { return m_cells; }

 private:
  double m_resolution;
  std::map<TerrainKey, Cell> m_cells;
};

}  // namespace mrpt_mapconv::oracle
