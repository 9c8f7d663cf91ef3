#pragma once

#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/sim/Scenario.h>
#include <mrpt_mapconv/sim/Simulator.h>

#include <cstdint>
#include <functional>

namespace mrpt_mapconv::sim
{
/** What a simulation came to. */
struct SimulationSummary
{
  double seconds = 0;  //!< from the first to the last moment
  double way = 0;      //!< of the robot [m]
  std::size_t moments = 0, scans = 0, keyFrames = 0;
  std::size_t returns3D = 0;  //!< points of all 3D scans
};

/** Adds to each cell of a layer the returns of a moment's 3D scans whose true place is over it. */
void countReturns(const Moment& moment, grid::Layer<float>& inView);

/** Simulates a scenario into files. The same seed gives the same bytes; the memory that is needed
 * does not grow with the simulated time.
 *
 * - `scans.rawlog`: observations one by one: at each moment odometry, with [log] poses the
 * estimated pose, and the scans;
 * - `frames.rawlog`: pairs of action (the odometry's increment, with a Gaussian as wide as its
 * noise) and sensory frame (all scans of a moment); the first action is no movement;
 * - `scans.simplemap`: every [log] keyFrameEvery-th moment with a 3D scan, at its estimated pose;
 * - `trajectory.csv`: t,x,y,z,yaw,pitch,roll of the true pose at each moment [s, m, rad];
 * - `truth.tif`: bands floor, ceiling, slope, aerial, ground as truthLayers() gives them, and
 *   inView: how many 3D returns each cell got, without noise;
 * - `truth_NAME.png`: pictures of the bands, that of inView on a logarithmic scale.
 *
 * \param progress told the share that is done, 0 … 1; may be empty
 * \exception std::runtime_error naming the file and the reason if one cannot be written */
SimulationSummary simulateTo(files::OutputDir& out, const Scenario& scenario, std::uint64_t seed,
                             const std::function<void(double)>& progress = {});

}  // namespace mrpt_mapconv::sim
