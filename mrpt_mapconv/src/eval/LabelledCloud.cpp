#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/eval/LabelledCloud.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/sim/Simulator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace mrpt_mapconv::eval
{
namespace
{
std::uint8_t classOf(bool isGround) { return isGround ? cloud::kGround : cloud::kUnclassified; }

void append(const observation::SensorPoints& seen, cloud::PointCloud& cloud)
{
  for (const auto& point : seen.points)
  {
    const auto place = seen.sensorPose.composePoint({point.x, point.y, point.z});
    cloud.x.push_back(place.x);
    cloud.y.push_back(place.y);
    cloud.z.push_back(place.z);
  }
}
}  // namespace

std::size_t LabelledCloud::groundPoints() const
{
  return static_cast<std::size_t>(std::count(truth.begin(), truth.end(), cloud::kGround));
}

LabelledCloud simulateCloud(const sim::Scenario& scenario, std::uint64_t seed, int every,
                            const std::function<void(double)>& progress)
{
  LabelledCloud labelled;
  observation::SensorPoints seen;
  sim::Simulator simulator(scenario, seed);
  for (int scans = 0; const auto moment = simulator.next();)
  {
    if (progress) progress(moment->seconds / scenario.trajectory.duration());
    for (const sim::Scan& scan : moment->scans)
    {
      if (!scan.is3D || scans++ % every != 0) continue;
      observation::sensorPoints(*scan.observation, moment->pose, seen);
      append(seen, labelled.cloud);
      for (const std::int32_t body : scan.bodies)
        labelled.truth.push_back(
            classOf(scenario.world.primitive(static_cast<std::size_t>(body)).isGround()));
    }
  }
  return labelled;
}

LabelledCloud readLabelledCloud(const std::string& file, const std::string& groundFile)
{
  LabelledCloud labelled;
  labelled.cloud = cloud::readCloudFile(file);
  const auto& all = labelled.cloud;
  const auto ground = cloud::readCloudFile(groundFile, cloud::CloudReading{all.origin, {}});
  std::set<std::tuple<double, double, double>> places;
  for (std::size_t i = 0; i < ground.size(); ++i)
    places.emplace(ground.x[i], ground.y[i], ground.z[i]);
  for (std::size_t i = 0; i < all.size(); ++i)
    labelled.truth.push_back(classOf(places.count({all.x[i], all.y[i], all.z[i]}) > 0));
  return labelled;
}

grid::Layer<float> trueGround(const sim::World& world, const grid::GridFrame& frame)
{
  grid::Layer<float> heights(frame, std::numeric_limits<float>::quiet_NaN());
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
      if (const auto z = world.groundAt(frame.centreOf(frame.x0 + x), frame.centreOf(frame.y0 + y)))
        heights.at(x, y) = static_cast<float>(*z);
  return heights;
}

}  // namespace mrpt_mapconv::eval
