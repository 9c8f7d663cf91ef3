#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "SensorKinds.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3Df;

namespace
{
constexpr int kMostSteps = 100000, kMostBeams = 4096;
constexpr std::size_t kMostRays = 10'000'000;

/** A spinning lidar, all beams of all its steps at one instant. */
class Lidar : public Sensor
{
 public:
  Lidar(SensorParams params, std::vector<TPoint3Df> directions)
      : Sensor(std::move(params), std::move(directions))
  {
  }

 protected:
  mrpt::obs::CObservation::Ptr observation(const std::vector<float>& ranges) const override
  {
    auto cloud = mrpt::maps::CSimplePointsMap::Create();
    cloud->reserve(ranges.size());
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
      if (ranges[i] <= 0) continue;
      const TPoint3Df p = directions()[i] * ranges[i];
      cloud->insertPointFast(p.x, p.y, p.z);
    }
    auto scan = mrpt::obs::CObservationPointCloud::Create();
    scan->pointcloud = std::move(cloud);
    return scan;
  }
};

std::vector<double> evenElevations(params::StrictSection& section)
{
  const int beams = readCount(section, "beams", 1, kMostBeams);
  const double low = readWithin(section, "elevationMin", -90, 90);
  const double high = readWithin(section, "elevationMax", -90, 90);
  if (high < low) section.fail("elevationMax", "at least elevationMin");
  std::vector<double> elevations;
  elevations.reserve(static_cast<std::size_t>(beams));
  for (int i = 0; i < beams; ++i)
    elevations.push_back(beams > 1 ? low + (high - low) * i / (beams - 1) : (low + high) / 2);
  return elevations;
}

std::vector<double> readElevations(params::StrictSection& section)
{
  if (!section.has("elevations")) return evenElevations(section);
  if (section.has("beams")) section.fail("beams", "left out: elevations already say them");
  std::vector<double> elevations;
  section.read("elevations", elevations);
  const auto bad = [](double e) { return std::abs(e) > 90; };
  if (std::any_of(elevations.begin(), elevations.end(), bad))
    section.fail("elevations", "angles from -90 to 90 [degrees]");
  return elevations;
}
}  // namespace

std::unique_ptr<Sensor> readLidar(params::StrictSection& section, SensorParams params)
{
  const auto elevations = readElevations(section);
  const int steps = readCount(section, "azimuthSteps", 1, kMostSteps);
  if (elevations.size() * static_cast<std::size_t>(steps) > kMostRays)
    section.fail("azimuthSteps", "smaller: beams times steps may be 10 million");
  std::vector<TPoint3Df> directions;
  for (int i = 0; i < steps; ++i)
    for (const double elevation : elevations)
      directions.push_back(directionAt(360.0 * i / steps, elevation));
  return std::make_unique<Lidar>(std::move(params), std::move(directions));
}

}  // namespace mrpt_mapconv::sim
