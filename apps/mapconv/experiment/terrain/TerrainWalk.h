#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt_mapconv/sim/Scenario.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "output/Progress.h"

namespace mapconv
{
/** The scans of a robot on its way through a world. */
class TerrainWalk
{
 public:
  /** Simulates it.
   * \param poseNoise times the world's noise of pose estimates; points are the same for any
   * \exception std::exception in one line naming the file if it cannot be read */
  TerrainWalk(const std::string& worldFile, const std::vector<double>& poseNoise,
              std::uint32_t seed, int maxScans, Progress& progress);

  const mrpt_mapconv::sim::World& world() const { return m_scenario.world; }
  std::size_t points() const;
  /** As what a map gets, at the poses that are estimated with one of the noises. Valid as long as
   * this. */
  std::vector<mrpt_mapconv::terrain::TerrainScan> scans(std::size_t noise) const;
  /** What points are uncertain by, likewise. */
  mrpt_mapconv::terrain::PointSigmas sigmas(std::size_t noise) const;

 private:
  struct Poses
  {
    std::vector<mrpt::poses::CPose3D> robot, sensor;  //!< -> map
  };
  /** \param withPoints also keep the points */
  Poses simulate(double poseNoise, std::uint32_t seed, int maxScans, bool withPoints,
                 Progress& progress);

  mrpt_mapconv::sim::Scenario m_scenario;
  std::vector<double> m_noise;
  std::vector<std::vector<mrpt::math::TPoint3Df>>
      m_points;                //!< of each scan, in its sensor's frame
  std::vector<Poses> m_poses;  //!< with each noise
};

}  // namespace mapconv
