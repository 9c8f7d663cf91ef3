#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/params/IniText.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace mrpt_mapconv::sim
{
using mrpt::config::CConfigFileMemory;
using mrpt::math::TPoint3D;
using params::StrictSection;

namespace
{
constexpr const char* kSensorPrefix = "sensor.";

std::vector<std::string> sensorSections(const CConfigFileMemory& ini)
{
  std::vector<std::string> all, sections;
  ini.getAllSections(all);
  const std::string prefix = kSensorPrefix;
  for (const auto& name : all)
    if (name.compare(0, prefix.size(), prefix) == 0) sections.push_back(name);
  std::sort(sections.begin(), sections.end());
  return sections;
}

using Sensors = std::vector<std::unique_ptr<const Sensor>>;

Sensors readSensors(const CConfigFileMemory& ini)
{
  Sensors sensors;
  for (const auto& name : sensorSections(ini))
  {
    StrictSection section(ini, name);
    sensors.push_back(readSensor(section));
  }
  if (sensors.empty())
    throw std::runtime_error("there is no sensor: a section 'sensor.NAME' must be there");
  return sensors;
}

std::string listed(const Sensors& sensors)
{
  std::string names;
  for (const auto& sensor : sensors) names.append(" '").append(sensor->params().name).append("'");
  return names;
}

void checkName(const std::string& name, const Sensors& sensors)
{
  if (std::none_of(sensors.begin(), sensors.end(),
                   [&](const auto& sensor) { return sensor->params().name == name; }))
    throw std::runtime_error("there is no sensor '" + name + "'; it must be one of" +
                             listed(sensors));
}

/** Leaves those that the robot has. \param names of these; empty: all that are not spare */
void chooseSensors(const std::vector<std::string>& names, Sensors& sensors)
{
  for (const std::string& name : names) checkName(name, sensors);
  const auto isLeft = [&](const auto& sensor)
  {
    const SensorParams& params = sensor->params();
    return names.empty() ? params.spare
                         : std::find(names.begin(), names.end(), params.name) == names.end();
  };
  sensors.erase(std::remove_if(sensors.begin(), sensors.end(), isLeft), sensors.end());
  if (sensors.empty())
    throw std::runtime_error("all sensors are spare: one must be asked for by its name");
}

void readAtLeast(StrictSection& section, const std::string& key, double low, double& value)
{
  section.read(key, value);
  if (value < low) section.fail(key, "a number >= " + std::to_string(static_cast<int>(low)));
}

NoiseParams readNoise(const CConfigFileMemory& ini)
{
  StrictSection section(ini, "noise");
  NoiseParams noise;
  readAtLeast(section, "odometryPerMetre", 0, noise.odometryPerMetre);
  readAtLeast(section, "odometryYawPerMetre", 0, noise.odometryYawPerMetre);
  readAtLeast(section, "odometryYawPerTurn", 0, noise.odometryYawPerTurn);
  section.read("odometryDrift", noise.odometryDrift);
  readAtLeast(section, "posePosition", 0, noise.posePosition);
  readAtLeast(section, "poseAngle", 0, noise.poseAngle);
  readAtLeast(section, "poseHeight", 0, noise.poseHeight);
  readAtLeast(section, "poseTilt", 0, noise.poseTilt);
  section.refuseUnknown("the noise");
  return noise;
}

LogParams readLog(const CConfigFileMemory& ini)
{
  StrictSection section(ini, "log");
  LogParams log;
  section.read("poses", log.poses);
  section.read("keyFrameEvery", log.keyFrameEvery);
  if (log.keyFrameEvery < 1) section.fail("keyFrameEvery", "a whole number >= 1");
  section.refuseUnknown("the log");
  return log;
}

/** Refuses a truth that no memory would hold. */
void checkTruthFrame(const StrictSection& section, const Scenario& scenario)
{
  try
  {
    frameOf(scenario.world, scenario.truthResolution);
  }
  catch (const std::invalid_argument&)
  {
    const std::string right = "that the truth has at most 4e7 cells, 1e5 on a side";
    if (section.has("resolution")) section.fail("resolution", "so large " + right);
    throw std::runtime_error("section 'world': bounds = " + placeText(scenario.world.min()) +
                             " to " + placeText(scenario.world.max()) +
                             " is not valid: it must be so small " + right +
                             " of 0.1 m (or give a larger resolution in section 'truth')");
  }
}

void readTruth(const CConfigFileMemory& ini, Scenario& scenario)
{
  StrictSection section(ini, "truth");
  section.read("resolution", scenario.truthResolution);
  if (!(scenario.truthResolution > 0)) section.fail("resolution", "a number > 0 [m]");
  section.read("minClearance", scenario.truth.minClearance);
  section.read("robotHeight", scenario.truth.robotHeight);
  section.read("maxSlope", scenario.truth.maxSlope);
  section.read("maxStep", scenario.truth.maxStep);
  section.refuseUnknown("the truth");
  checkTruthFrame(section, scenario);
  section.checked([&] { scenario.truth.check(); });
}

/** Bodies beyond the bounds are no part of the truth; who wrote one mistook a number. */
void checkBodies(const World& world)
{
  const TPoint3D &low = world.min(), &high = world.max();
  for (std::size_t i = 0; i < world.size(); ++i)
  {
    const Footprint area = world.primitive(i).footprint();
    Mesh mesh;
    world.primitive(i).appendMesh(mesh);
    const auto [bottom, top] =
        std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                            [](const auto& a, const auto& b) { return a[2] < b[2]; });
    if (area.xMax < low.x || area.xMin > high.x || area.yMax < low.y || area.yMin > high.y ||
        (*top)[2] < low.z || (*bottom)[2] > high.z)
      throw std::runtime_error("section '" + world.name(i) +
                               "': the body is outside the world's bounds " + placeText(low) +
                               " to " + placeText(high) + "; some of it must be within them");
  }
}

/** A run of more than a day cannot be meant. */
void checkDuration(const StrictSection& section, const Trajectory& trajectory)
{
  constexpr double kLongest = 24 * 3600;  // [s]
  if (trajectory.duration() <= kLongest) return;
  const std::string right = "such that the run takes at most 86400 s (24 h)";
  if (section.has("poses")) section.fail("poses", right);
  double moving = 0;
  const auto& knots = trajectory.knots();
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (knots[i].position != knots[i - 1].position) moving += knots[i].time - knots[i - 1].time;
  section.fail(2 * moving >= trajectory.duration() ? "speed" : "turnRate", right);
}

/** Walks along the way and throws where it does not lead through free space. */
class WayCheck
{
 public:
  /** \param key that the way was read from */
  WayCheck(const Scenario& scenario, std::string key) : m_scenario(scenario), m_key(std::move(key))
  {
  }

  void check() const
  {
    const auto& knots = m_scenario.trajectory.knots();
    for (std::size_t i = 0; i < knots.size(); ++i)
    {
      const bool isPoint = i == 0 || knots[i].number != knots[i - 1].number;
      checkAt(knots[i].time, knots[i].number, isPoint);
      if (i + 1 == knots.size()) break;
      const double way = knots[i + 1].position.distanceTo(knots[i].position);
      const int steps = static_cast<int>(std::ceil(way / kStep));
      for (int k = 1; k < steps; ++k)
        checkAt(knots[i].time + (knots[i + 1].time - knots[i].time) * k / steps, knots[i].number,
                false);
    }
  }

 private:
  static constexpr double kStep = 0.05;      //!< [m]
  static constexpr double kOffFloor = 0.01;  //!< [m]

  void checkAt(double time, int number, bool atPoint) const
  {
    const auto pose = m_scenario.trajectory.poseAt(time);
    const TPoint3D place = pose.translation();
    const std::string where =
        atPoint ? "number " + std::to_string(number) + " at " + placeText(place)
                : "the way from number " + std::to_string(number) + " to " +
                      std::to_string(number + 1) + ", at " + placeText(place) + ",";
    checkPoint(place + TPoint3D(0, 0, kOffFloor), where + " puts the robot");
    for (const auto& sensor : m_scenario.sensors)
      checkPoint((pose + sensor->params().pose).translation(),
                 where + " puts sensor '" + sensor->params().name + "'");
  }

  void checkPoint(const TPoint3D& point, const std::string& who) const
  {
    const World& world = m_scenario.world;
    const TPoint3D &low = world.min(), &high = world.max();
    const bool within = point.x >= low.x && point.y >= low.y && point.z >= low.z &&
                        point.x <= high.x && point.y <= high.y && point.z <= high.z;
    if (within && !world.isSolid(point)) return;
    throw std::runtime_error("section 'trajectory': " + m_key + ": " + who +
                             (within ? " inside '" + bodyAt(point) + "'; it must be in free space"
                                     : " at " + placeText(point) +
                                           ", but it must be within the bounds " + placeText(low) +
                                           " to " + placeText(high)));
  }

  std::string bodyAt(const TPoint3D& point) const
  {
    const World& world = m_scenario.world;
    for (std::size_t i = 0; i < world.size(); ++i)
    {
      std::vector<Solid> solids;
      world.primitive(i).appendSolids(point.x, point.y, solids);
      for (const Solid& solid : solids)
        if (solid.bottom <= point.z && point.z <= solid.top) return world.name(i);
    }
    return "a body";
  }

  const Scenario& m_scenario;
  const std::string m_key;
};

Scenario readScenario(const CConfigFileMemory& ini, const std::vector<std::string>& names)
{
  World world = World::fromIni(ini, {kSensorPrefix, "trajectory", "noise", "log", "truth"});
  checkBodies(world);
  auto sensors = readSensors(ini);
  chooseSensors(names, sensors);
  if (!ini.sectionExists("trajectory"))
    throw std::runtime_error("there is no trajectory: a section 'trajectory' must be there");
  StrictSection section(ini, "trajectory");
  Trajectory trajectory = Trajectory::read(section, world);
  checkDuration(section, trajectory);
  Scenario scenario{std::move(world),
                    std::move(sensors),
                    std::move(trajectory),
                    readNoise(ini),
                    readLog(ini),
                    {},
                    0.1};
  readTruth(ini, scenario);
  WayCheck(scenario, section.has("poses") ? "poses" : "waypoints").check();
  return scenario;
}
}  // namespace

Scenario Scenario::load(const std::string& file, const std::vector<std::string>& sensors)
{
  const std::string text = params::readIniText(file);
  try
  {
    return readScenario(CConfigFileMemory(text), sensors);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error(file + ": " + params::oneLine(error));
  }
}

}  // namespace mrpt_mapconv::sim
