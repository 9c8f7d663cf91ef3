#pragma once

#include <mrpt_mapconv/eval/ScanShapeMaps.h>
#include <mrpt_mapconv/eval/ScanShapeScores.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <string>
#include <vector>

#include "unit/sim/WorldText.h"

// Scans of a few returns each, by a sensor that looks along +x over cells of 0.1 m.
namespace mrpt_mapconv::fixtures
{
constexpr double kCell = 0.1;  // [m]
const grid::GridFrame kFrame{kCell, -30, -30, 60, 60};

/** A world of somebody who walks and something that stands. */
inline const sim::World& world()
{
  static const sim::World theWorld = test::worldOf(
      "[person.anna]\npath = 1 0  2 0\nspeed = 1\n[box.crate]\nmin = 2 0 0\nmax = 2.1 0.1 1\n");
  return theWorld;
}

/** The number of a body. */
inline std::int32_t body(const std::string& name)
{
  for (std::size_t i = 0; i < world().size(); ++i)
    if (world().name(i) == name) return static_cast<std::int32_t>(i);
  throw std::logic_error("no body is called " + name);
}

/** A return in the middle of cell (x, 0). */
struct Return
{
  std::int32_t x = 0;
  std::string body = "box.crate";
  bool mirrored = false;
  double height = 0.5;  //!< [m]
};

inline scan::ProfileParams uncut()
{
  scan::ProfileParams params;
  params.reflectionFilter = false;
  params.maxRange = 2.5;
  return params;
}

/** Of a sensor in the middle of cell (x, 0). */
inline eval::PosedScan scanFrom(std::int32_t x, const std::vector<Return>& returns)
{
  constexpr double kHeight = 1;  // of the sensor [m]
  eval::PosedScan scan;
  scan.view.sensorPose = {(x + 0.5) * kCell, 0.5 * kCell, kHeight, 0, 0, 0};
  scan.points.sensorPose = scan.view.sensorPose;
  for (const Return& r : returns)
    scan.points.points.push_back(
        {static_cast<float>((r.x - x) * kCell), 0, static_cast<float>(r.height - kHeight)});
  return scan;
}

/** What its returns come from. */
inline sim::Scan seenBy(const std::vector<Return>& returns)
{
  sim::Scan seen;
  for (const Return& r : returns)
  {
    seen.bodies.push_back(body(r.body));
    seen.mirrored.push_back(r.mirrored);
  }
  return seen;
}

inline scan::ScanProfile profileOf(const eval::PosedScan& scan)
{
  scan::ScanProfile profile;
  profile.compute(scan.points.points, scan.view, kCell, uncut());
  return profile;
}

/** Of a sensor in cell (0, 0). */
inline scan::ScanProfile profileOf(const std::vector<Return>& returns)
{
  return profileOf(scanFrom(0, returns));
}

/** A layer that has a value in some of the cells (x, 0), and another one in all others. */
template <class T>
grid::Layer<T> layerWith(const std::vector<std::int32_t>& cells, T there, T elsewhere)
{
  grid::Layer<T> layer(kFrame, elsewhere);
  for (const std::int32_t x : cells) layer.cells()[kFrame.indexOfKey(x, 0)] = there;
  return layer;
}

template <class T>
const T& cellOf(const grid::Layer<T>& layer, std::int32_t x)
{
  return layer.cells()[kFrame.indexOfKey(x, 0)];
}

/** All is free but some of the cells (x, 0). */
inline eval::ScanShapeTruth truthWith(const std::vector<std::int32_t>& occupied)
{
  eval::ScanShapeTruth truth;
  truth.obstacles = layerWith(occupied, 1.0f, grid::kFree);
  return truth;
}
}  // namespace mrpt_mapconv::fixtures
