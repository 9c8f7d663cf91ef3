#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <mrpt_mapconv/eval/LabelScore.h>
#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>
#include <mrpt_mapconv/sim/RayCaster.h>
#include <mrpt_mapconv/sim/Scenario.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

// The method of Mora et al. on scans of the simulated office, taken at true poses.

namespace mrpt_mapconv::sim
{
namespace
{
using mrpt::poses::CPose3D;

constexpr double kResolution = 0.05;                       // [m]
constexpr double kObstacleMin = 0.05, kObstacleMax = 1.5;  // heights that the robot hits [m]

struct OfficeScan
{
  CPose3D robot;
  observation::SensorPoints seen;
  std::vector<std::uint8_t> mirrored;
};

/** Scans all along the way. */
class Office
{
 public:
  Office()
  {
    const auto& lidar = *scenario.sensors.front();
    EXPECT_TRUE(lidar.is3D());
    RayCaster caster(scenario.world);
    constexpr int kScans = 60;
    for (int i = 0; i < kScans; ++i)
    {
      const double time = scenario.trajectory.duration() * i / kScans;
      caster.moveTo(time);
      const auto pose = scenario.trajectory.poseAt(time);
      const Scan scan = lidar.scan(caster, pose, static_cast<std::uint64_t>(i));
      scans.push_back({pose, *observation::sensorPoints(*scan.observation, pose), scan.mirrored});
    }
  }

  const Scenario scenario =
      Scenario::load(std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/worlds/office.ini");
  std::vector<OfficeScan> scans;
};

const Office& office()
{
  static const Office theOffice;
  return theOffice;
}

scan::ProfileParams paramsOf(bool filter)
{
  scan::ProfileParams params;
  params.reflectionFilter = filter;
  params.structureMinZ = 2.3;
  params.structureMaxZ = 2.6;
  return params;
}

/** The map of all scans in a world that is turned about its origin. */
grid::Layer<float> mapOf(const grid::GridFrame& frame, bool filter, double turn = 0)
{
  const CPose3D turned(0, 0, 0, turn, 0, 0);
  std::vector<std::int8_t> cells(frame.size(), 0);
  scan::ScanProfile profile;
  const scan::LogOddsUpdate update;
  for (const auto& scan : office().scans)
  {
    profile.compute(scan.seen.points, {turned + scan.seen.sensorPose, scan.robot.z(), 0},
                    kResolution, paramsOf(filter));
    update.apply(profile, frame, cells.data());
  }
  grid::Layer<float> map(frame, grid::kUnknown);
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i] != 0) map.cells()[i] = cells[i] > 0 ? grid::kFree : 1.0f;
  return map;
}

/** All places that a scan may reach, however the world is turned. */
grid::GridFrame wholeFrame()
{
  const auto& world = office().scenario.world;
  const double reach = 21 + std::hypot(world.max().x, world.max().y);
  const auto half = static_cast<std::int32_t>(reach / kResolution);
  return {kResolution, -half, -half, 2 * half, 2 * half};
}

/** What stands at points of a lattice of 1 cm: 1 solid at the robot's heights, 0 ground, −1 none.
 */
class FineTruth
{
 public:
  FineTruth() : m_layer({kStep, -40, -40, 2520, 1720}, grid::kUnknown)
  {
    const auto& frame = m_layer.frame();
    for (std::int32_t iy = 0; iy < frame.height; ++iy)
      for (std::int32_t ix = 0; ix < frame.width; ++ix)
        m_layer.at(ix, iy) = valueAt((frame.x0 + ix + 0.5) * kStep, (frame.y0 + iy + 0.5) * kStep);
  }

  float at(double x, double y) const
  {
    const auto& frame = m_layer.frame();
    const auto kx = grid::cellKey(x, kStep), ky = grid::cellKey(y, kStep);
    return frame.containsKey(kx, ky) ? m_layer.cells()[frame.indexOfKey(kx, ky)] : grid::kUnknown;
  }

 private:
  static constexpr double kStep = 0.01;  // [m]

  float valueAt(double x, double y)
  {
    const World& world = office().scenario.world;
    if (x < world.min().x || x > world.max().x || y < world.min().y || y > world.max().y)
      return grid::kUnknown;
    m_solids.clear();
    world.solidsAt(x, y, m_solids);
    const auto isObstacle = [](const Solid& solid)
    { return solid.bottom < kObstacleMax && solid.top > kObstacleMin; };
    if (std::any_of(m_solids.begin(), m_solids.end(), isObstacle)) return 1;
    return m_solids.empty() ? grid::kUnknown : grid::kFree;
  }

  grid::Layer<float> m_layer;
  std::vector<Solid> m_solids;
};

/** The truth on a frame in a world that is turned about its origin. */
grid::Layer<float> truthOf(const grid::GridFrame& frame, double turn)
{
  static const FineTruth fine;
  const double c = std::cos(turn), s = std::sin(turn);
  const auto at = [&](double x, double y) { return fine.at(c * x + s * y, c * y - s * x); };
  grid::Layer<float> truth(frame, grid::kUnknown);
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
    {
      const double x = (frame.x0 + ix) * kResolution, y = (frame.y0 + iy) * kResolution;
      float& cell = truth.at(ix, iy);
      cell = at(x + kResolution / 2, y + kResolution / 2);
      if (cell < 0) continue;
      for (int i = 0; i < 25; ++i)
        cell = std::max(cell, at(x + 0.005 + 0.01 * (i % 5), y + 0.005 + 0.01 * (i / 5)));
    }
  return truth;
}

double fScoreAt(double turn)
{
  const auto frame = wholeFrame();
  const auto truth = truthOf(frame, turn);
  const auto start = CPose3D(0, 0, 0, turn, 0, 0) + office().scans.front().robot;
  const auto should = eval::cellsToLabel(truth, start.x(), start.y());
  return eval::scoreLabels(mapOf(frame, true, turn), truth, should).fScore();
}

/** Cells that only mirrored returns of the object slice fall into. */
eval::CellMask ghostCells(const grid::GridFrame& frame)
{
  constexpr std::uint8_t kGhost = 1, kReal = 2;
  eval::CellMask seen(frame, 0);
  for (const auto& scan : office().scans)
    for (std::size_t i = 0; i < scan.seen.points.size(); ++i)
    {
      const auto& p = scan.seen.points[i];
      const auto place = scan.seen.sensorPose.composePoint(mrpt::math::TPoint3D(p.x, p.y, p.z));
      if (place.z < kObstacleMin || place.z > kObstacleMax) continue;
      const auto kx = grid::cellKey(place.x, kResolution), ky = grid::cellKey(place.y, kResolution);
      if (frame.containsKey(kx, ky))
        seen.cells()[frame.indexOfKey(kx, ky)] |= scan.mirrored[i] ? kGhost : kReal;
    }
  for (auto& cell : seen.cells()) cell = cell == kGhost;
  return seen;
}

std::size_t occupiedOf(const grid::Layer<float>& map, const eval::CellMask& cells)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < map.cells().size(); ++i)
    count += cells.cells()[i] && grid::isOccupied(map.cells()[i]);
  return count;
}
}  // namespace

TEST(ScannedOffice, MirroredReturnsAreGhostsOnTheMapAndTheCutRemovesMost)
{
  const auto frame = wholeFrame();
  auto ghosts = ghostCells(frame);
  const auto truth = truthOf(frame, 0);
  for (std::size_t i = 0; i < ghosts.cells().size(); ++i)
    if (grid::isOccupied(truth.cells()[i])) ghosts.cells()[i] = 0;
  const std::size_t without = occupiedOf(mapOf(frame, false), ghosts),
                    with = occupiedOf(mapOf(frame, true), ghosts);
  std::printf("ghost cells that are occupied: %zu without the cut, %zu with it\n", without, with);
  EXPECT_GT(without, 500u);
  // Not all: a free-standing mirror's lie within the room, a ceiling-high pane's walls are
  // mirrored, and so near a wall that the lidar does not see its upper end nothing is cut.
  EXPECT_LT(2 * with, without);
}

TEST(ScannedOffice, TheWayTheWorldIsTurnedMattersLittle)
{
  const double upright = fScoreAt(0);
  EXPECT_GT(upright, 0.9);
  for (const double degrees : {17.0, 45.0})
  {
    const double turned = fScoreAt(mrpt::DEG2RAD(degrees));
    std::printf("F-score %.4f upright, %.4f turned by %g degrees\n", upright, turned, degrees);
    EXPECT_NEAR(turned, upright, 0.01) << degrees;
  }
}

}  // namespace mrpt_mapconv::sim
