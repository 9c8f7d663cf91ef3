#include "RandomBeams.h"

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace mrpt_mapconv::test
{
using mrpt::math::TPoint3Df;

namespace
{
constexpr double kResolutions[] = {0.05, 0.07, 0.1, 0.25, 0.3, 1.0};
constexpr int kReach = 40;  //!< of most beams [voxels]

/** A key around which a sensor is: near 0, some 3000 m away or at the end of the range. */
int randomHome(Rng& rng, double resolution)
{
  switch (pick(rng, 0, 5))
  {
    case 0:
      return std::max(-32000, static_cast<int>(-3000 / resolution));
    case 1:
      return 32767 - pick(rng, 0, 20);
    case 2:
      return -32768 + pick(rng, 0, 20);
    default:
      return pick(rng, -40, 40);
  }
}
}  // namespace

RandomBeams::RandomBeams(Rng& rng)
    : m_rng(rng),
      m_resolution(kResolutions[pick(rng, 0, 5)]),
      m_x(randomHome(rng, m_resolution)),
      m_y(randomHome(rng, m_resolution)),
      m_z(randomHome(rng, m_resolution))
{
}

/** A place in a voxel: on its lower face, in its middle or anywhere. */
float RandomBeams::coordinate(int key)
{
  const double within[] = {0, 0, 0.5, uniform(m_rng, 0, 1)};
  return static_cast<float>((key + within[pick(m_rng, 0, 3)]) * m_resolution);
}

mrpt::poses::CPose3D RandomBeams::pose()
{
  const auto at = [this](int home)
  {
    const int key = home + pick(m_rng, -4, 4);
    return static_cast<double>(coordinate(std::max(-32767, std::min(32766, key))));
  };
  const double x = at(m_x), y = at(m_y), z = at(m_z);
  if (chance(m_rng, 60)) return {x, y, z, 0, 0, 0};
  const auto angle = [this] { return uniform(m_rng, -M_PI, M_PI); };
  return {x, y, z, angle(), angle() / 2, angle()};
}

/** A point from which no range of 65536 voxels to a side is wide enough, wherever the axes are. */
TPoint3Df RandomBeams::outside()
{
  const double along = uniform(m_rng, 120000, 200000) * m_resolution;
  return {static_cast<float>(chance(m_rng, 50) ? along : -along), 0, 0};
}

TPoint3Df RandomBeams::point(const mrpt::poses::CPose3D& sensor,
                             const std::vector<TPoint3Df>& before)
{
  const auto length = [this](double voxels)
  { return static_cast<float>(uniform(m_rng, -voxels, voxels) * m_resolution); };
  switch (pick(m_rng, 0, 9))
  {
    case 0:  // along an axis
    {
      TPoint3Df end{0, 0, 0};
      (&end.x)[pick(m_rng, 0, 2)] = length(kReach);
      return end;
    }
    case 1:  // along a diagonal
    {
      const float along = length(kReach), sign = chance(m_rng, 50) ? 1.0f : -1.0f;
      return {along, sign * along, chance(m_rng, 50) ? along : 0.0f};
    }
    case 2:  // on faces and in corners, as far as floats can tell
    case 3:
    {
      const auto to = [this](double from, int home) {
        return static_cast<float>(static_cast<double>(coordinate(home + pick(m_rng, -20, 20))) -
                                  from);
      };
      return {to(sensor.x(), m_x), to(sensor.y(), m_y), to(sensor.z(), m_z)};
    }
    case 4:  // in the sensor's voxel, or just beyond it
      return {length(0.6), length(0.6), length(0.6)};
    case 5:
      if (!before.empty())
        return before[static_cast<std::size_t>(
            pick(m_rng, 0, static_cast<int>(before.size()) - 1))];
      [[fallthrough]];
    case 6:
      if (chance(m_rng, 20)) return outside();
      if (chance(m_rng, 20)) return {length(400), length(400), length(400)};
      [[fallthrough]];
    default:
      return {length(kReach), length(kReach), length(kReach)};
  }
}

observation::SensorPoints RandomBeams::scan(int beams)
{
  observation::SensorPoints scan;
  scan.sensorPose = pose();
  const int noReturns = chance(m_rng, 40) ? pick(m_rng, 0, beams) : 0;
  for (int i = 0; i < beams; ++i)
  {
    auto& points = i < noReturns ? scan.noReturns : scan.points;
    points.push_back(point(scan.sensorPose, scan.points));
  }
  return scan;
}

std::string RandomBeams::text() const
{
  std::ostringstream out;
  out << "voxels of " << m_resolution << " m around (" << m_x << ", " << m_y << ", " << m_z << ")";
  return out.str();
}

voxel::TVoxelInsertionOptions randomInsertion(Rng& rng, double resolution)
{
  static constexpr double kHit[] = {0.5, 0.500001, 0.7, 0.9, 1},
                          kMiss[] = {0, 0.1, 0.4, 0.499999, 0.5},
                          kMin[] = {0, 0.1192, 0.4, 0.499999, 0.5},
                          kMax[] = {0.5, 0.500001, 0.7, 0.971, 1},
                          kThreshold[] = {0.3, 0.499999, 0.5, 0.500001, 0.6, 0.9};
  voxel::TVoxelInsertionOptions options;
  options.pruning = chance(rng, 70);
  if (chance(rng, 30)) options.maxrange = uniform(rng, 0.3, 30) * resolution;
  if (chance(rng, 30)) return options;
  while (true)  // some values exclude each other
  {
    options.probHit = kHit[pick(rng, 0, 4)];
    options.probMiss = kMiss[pick(rng, 0, 4)];
    options.clampingThresMin = kMin[pick(rng, 0, 4)];
    options.clampingThresMax = kMax[pick(rng, 0, 4)];
    options.occupancyThres = kThreshold[pick(rng, 0, 5)];
    try
    {
      options.check();
      return options;
    }
    catch (const std::invalid_argument&)
    {
    }
  }
}

voxel::TVoxelInsertionOptions finiteInsertion(Rng& rng, double resolution)
{
  auto options = randomInsertion(rng, resolution);
  while (options.clampingThresMin == 0 || options.clampingThresMax == 1)
    options = randomInsertion(rng, resolution);
  return options;
}

void addCubes(Rng& rng, const voxel::VoxelKey& around, octomap::OcTree& tree)
{
  static constexpr float kLogOdds[] = {-10, -2.1f, -2, -0.4f, 0, 0.85f, 3.5f, 3.6f, 10};
  for (int i = pick(rng, 1, 12); i > 0; --i)
  {
    const int side = 1 << pick(rng, 0, 5);
    const float logOdds = kLogOdds[pick(rng, 0, 8)];
    const auto first = [&](int key)
    { return std::max(-32768, std::min(32768 - side, (key + pick(rng, -40, 40)) & -side)); };
    const int x0 = first(around.x), y0 = first(around.y), z0 = first(around.z);
    for (int x = x0; x < x0 + side; ++x)
      for (int y = y0; y < y0 + side; ++y)
        for (int z = z0; z < z0 + side; ++z)
          tree.setNodeValue(oracle::octomapKey(x, y, z), logOdds, true);
  }
  if (chance(rng, 70)) tree.prune();
  tree.updateInnerOccupancy();
}

std::string text(const voxel::TVoxelInsertionOptions& options)
{
  std::ostringstream out;
  out << "hit " << options.probHit << ", miss " << options.probMiss << ", within ["
      << options.clampingThresMin << ", " << options.clampingThresMax << "], occupied from "
      << options.occupancyThres << ", maxrange " << options.maxrange
      << (options.pruning ? "" : ", unpruned");
  return out.str();
}

}  // namespace mrpt_mapconv::test
