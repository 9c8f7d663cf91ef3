#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt_mapconv/eval/LabelScore.h>
#include <mrpt_mapconv/params/IniText.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include <algorithm>
#include <cmath>
#include <regex>

// config/worlds/office.ini is what its comments say, and the robot's way through it is clear.
namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim;
using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;

const std::string kOffice = MRPT_MAPCONV_SOURCE_DIR "/config/worlds/office.ini";
constexpr double kRobotHeight = 1.5;  // [m]
constexpr double kCeiling = 2.7;      // [m]
constexpr double kDegree = 3.14159265358979323846 / 180;

const Scenario& office()
{
  static const Scenario scenario = Scenario::load(kOffice);
  return scenario;
}

bool begins(const std::string& name, const std::string& beginning)
{
  return name.compare(0, beginning.size(), beginning) == 0;
}

/** Numbers of the bodies of a name, or of those that begin with one that ends in '.' or '_'. */
std::vector<std::size_t> bodiesNamed(const std::string& wanted)
{
  const bool beginning = wanted.back() == '.' || wanted.back() == '_';
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < office().world.size(); ++i)
  {
    const std::string& name = office().world.name(i);
    if (beginning ? begins(name, wanted) : name == wanted) found.push_back(i);
  }
  return found;
}

/** True if a robot's column over a place is free, from just above the floor to `height` [m]. */
bool isFree(double x, double y, double height, std::vector<Solid>& scratch)
{
  constexpr double kFloor = 1e-3;
  office().world.solidsAt(x, y, scratch);
  return std::none_of(scratch.begin(), scratch.end(),
                      [&](const Solid& s) { return s.bottom < height && s.top > kFloor; });
}

/** The same all over a disc, whose rim is looked at closely. */
bool isDiscFree(double x, double y, double radius, double height)
{
  constexpr double kSpacing = 0.02;  // the thinnest bodies have 2.5 cm
  std::vector<Solid> scratch;
  const int rings = static_cast<int>(std::ceil(radius / kSpacing));
  for (int ring = 1; ring <= rings; ++ring)
  {
    const double r = radius * ring / rings;
    const int around = static_cast<int>(std::ceil(360 * kDegree * r / kSpacing));
    for (int i = 0; i < around; ++i)
    {
      const double angle = 360 * kDegree * i / around;
      if (!isFree(x + r * std::cos(angle), y + r * std::sin(angle), height, scratch)) return false;
    }
  }
  return isFree(x, y, height, scratch);
}

/** Where a person is at a time [s]. */
TPoint2D placeOf(const Primitive& person, double time)
{
  const auto shift = person.motion()->shiftAt(time);
  const auto corners = person.curved()->bounds();
  return {(corners[0].x + corners[1].x) / 2 + shift.x, (corners[0].y + corners[1].y) / 2 + shift.y};
}

// --- what it holds

TEST(Office, IsAScenarioOfTwoMinutes)
{
  EXPECT_GE(office().trajectory.duration(), 100);
  EXPECT_LE(office().trajectory.duration(), 140);
  EXPECT_TRUE(office().trajectory.isFlat());
  ASSERT_EQ(office().sensors.size(), 2u);
  const Sensor &lidar = *office().sensors[0], &scanner = *office().sensors[1];
  EXPECT_EQ(lidar.rays(), 128u * 1024u);
  EXPECT_FALSE(scanner.is3D());
  EXPECT_EQ(lidar.params().rate, scanner.params().rate);
  EXPECT_LT(scanner.params().pose.z(), 0.2);
  EXPECT_LT(lidar.params().pose.z(), kRobotHeight);
  EXPECT_EQ(office().truth.robotHeight, kRobotHeight);
  EXPECT_TRUE(office().log.poses);
}

TEST(Office, IsFurnished)
{
  EXPECT_GE(bodiesNamed("table.").size(), 8u);
  EXPECT_GE(bodiesNamed("chair.").size(), 24u);
  EXPECT_GE(bodiesNamed("shelf.").size(), 6u);
  EXPECT_GE(bodiesNamed("box.cupboard_").size(), 3u);
  EXPECT_GE(bodiesNamed("cylinder.pillar_").size(), 3u);
  EXPECT_GE(bodiesNamed("cylinder.bin_").size(), 4u);
  EXPECT_EQ(bodiesNamed("person.").size(), 4u);
}

struct Door
{
  double x, y;
  int number;
  bool alongX;  //!< the wall that it is in
};
const Door kDoors[] = {
    {4.94, 6.8, 1, true},       {7.65, 6.8, 2, true},   {12.84, 6.8, 3, true},
    {15.21, 6.8, 4, true},      {20.2, 6.8, 5, true},   {11.735, 1.87, 6, false},
    {4.57, 9.33, 7, true},      {11.45, 9.33, 8, true}, {12.275, 14.08, 9, false},
    {16.925, 14.43, 10, false}, {19.4, 9.33, 11, true}, {6.365, 3.14, 12, false}};

/** How far a door's opening reaches from a place in it [m]. */
double widthOf(const Door& door)
{
  constexpr double kStep = 0.005;
  std::vector<Solid> scratch;
  int steps = 0;
  for (const double side : {-kStep, kStep})
    for (int i = 1; i < 400; ++i, ++steps)
      if (!isFree(door.x + (door.alongX ? i * side : 0), door.y + (door.alongX ? 0 : i * side),
                  kRobotHeight, scratch))
        break;
  return steps * kStep;
}

TEST(Office, HalfOfItsDoorsHaveALintel)
{
  std::vector<Solid> solids;
  std::size_t lintels = 0;
  for (const Door& door : kDoors)
  {
    SCOPED_TRACE("door " + std::to_string(door.number));
    EXPECT_GE(widthOf(door), 0.95);
    EXPECT_LE(widthOf(door), 1.2);
    office().world.solidsAt(door.x, door.y, solids);
    ASSERT_EQ(solids.size(), 2u);  // the floor, and what is above
    EXPECT_NEAR(solids[0].top, 0, 1e-9);
    const bool lintel = solids[1].bottom < kCeiling - 0.01;
    EXPECT_NEAR(solids[1].bottom, lintel ? 2.05 : kCeiling, 1e-9);
    lintels += lintel;
    EXPECT_EQ(bodiesNamed("box.lintel_" + std::to_string(door.number)).size(), lintel ? 1u : 0u);
  }
  EXPECT_EQ(2 * lintels, std::size(kDoors));
  EXPECT_EQ(bodiesNamed("box.lintel_").size(), lintels);
}

TEST(Office, ItsCommentsNameEachDoor)
{
  const std::string text = params::readIniText(kOffice);
  const std::regex line("# door ([0-9]+): .*(with a lintel|open up to the ceiling)");
  std::size_t doors = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it, ++doors)
  {
    const bool lintel = (*it)[2] == "with a lintel";
    const std::string name = "box.lintel_" + (*it)[1].str();
    EXPECT_EQ(lintel, text.find("[" + name + "]") != std::string::npos) << name;
  }
  EXPECT_EQ(doors, std::size(kDoors));
}

// --- where one gets

TEST(Office, TheWayIsClear)
{
  constexpr double kClear = 0.35, kStep = 0.05;  // [m]
  const auto& trajectory = office().trajectory;
  const int steps = static_cast<int>(trajectory.duration() * 0.7 / kStep);
  for (int i = 0; i <= steps; ++i)
  {
    const auto place = trajectory.poseAt(trajectory.duration() * i / steps).translation();
    EXPECT_TRUE(isDiscFree(place.x, place.y, kClear, kRobotHeight)) << place.asString();
  }
}

TEST(Office, PeopleWalkThroughNothing)
{
  const auto& trajectory = office().trajectory;
  for (const std::size_t i : bodiesNamed("person."))
    for (int moment = 0; 0.1 * moment < trajectory.duration(); ++moment)
    {
      const double time = 0.1 * moment;
      const TPoint2D place = placeOf(office().world.primitive(i), time);
      EXPECT_TRUE(isDiscFree(place.x, place.y, 0.2, 1.83))
          << office().world.name(i) << " at " << time << " s: " << place.asString();
      const auto robot = trajectory.poseAt(time).translation();
      EXPECT_GT(std::hypot(place.x - robot.x, place.y - robot.y), 0.2 + 0.35)
          << office().world.name(i) << " and the robot at " << time << " s";
    }
}

/** What a robot of 1.5 m can hit. */
grid::Layer<float> obstacles()
{
  return obstacleLayer(office().world, frameOf(office().world, office().truthResolution), 0.05,
                       kRobotHeight);
}

struct Place
{
  const char* name;
  double x, y;
};

TEST(Office, EveryRoomButTheAtriumIsReachedFromTheStart)
{
  const auto start = office().trajectory.poseAt(0).translation();
  const auto truth = obstacles();
  const eval::CellMask reached = eval::cellsToLabel(truth, start.x, start.y);
  const auto isReached = [&](const Place& place)
  {
    const auto& frame = reached.frame();
    const auto key = [&](double v)
    { return static_cast<std::int32_t>(std::floor(v / frame.resolution)); };
    return reached.cells()[frame.indexOfKey(key(place.x), key(place.y))] != 0;
  };
  for (const Place& place :
       {Place{"hall, west end", 1.2, 8.0}, Place{"hall, east end", 23.4, 7.9},
        Place{"west office", 5.1, 2.0}, Place{"middle office", 9.0, 2.6}, Place{"store", 13.0, 5.5},
        Place{"copy room", 15.0, 5.5}, Place{"open-plan office", 20.0, 4.6},
        Place{"its part", 13.0, 2.2}, Place{"kitchen", 3.0, 14.6}, Place{"meeting room", 6.5, 14.6},
        Place{"archive", 14.5, 14.5}, Place{"laboratory", 18.0, 14.9}})
    EXPECT_TRUE(isReached(place)) << place.name;
  EXPECT_FALSE(isReached({"atrium", 14.5, 10.5}));
  std::size_t cells = 0;
  for (const auto cell : reached.cells()) cells += cell != 0;
  const double area =
      static_cast<double>(cells) * truth.frame().resolution * truth.frame().resolution;
  EXPECT_GT(area, 270);  // of 24 x 16 m
  EXPECT_LT(area, 360);
}

// --- glass and steel

TEST(Office, GlassStandsUnderBeamsExceptForThePaneUpToTheCeiling)
{
  const auto glass = bodiesNamed("pane.glass_"), all = bodiesNamed("pane.");
  EXPECT_EQ(glass.size(), 6u);
  EXPECT_EQ(all.size(), 7u);
  for (const std::size_t i : all)
  {
    const World& world = office().world;
    const Primitive& pane = world.primitive(i);
    SCOPED_TRACE(world.name(i));
    EXPECT_NEAR(pane.transparency(), 0.85, 1e-9);
    EXPECT_NEAR(pane.mirror(), 0.06, 1e-9);
    const Footprint area = pane.footprint();
    const double x = (area.xMin + area.xMax) / 2, y = (area.yMin + area.yMax) / 2;
    std::vector<Solid> solids;
    pane.appendSolids(x, y, solids);
    ASSERT_EQ(solids.size(), 1u);
    EXPECT_EQ(solids[0].bottom, 0);
    EXPECT_NEAR(solids[0].top, begins(world.name(i), "pane.glass_") ? 2.2 : kCeiling, 1e-9);
    EXPECT_TRUE(world.isSolid({x, y, 2.45}));  // above is a beam, or still the pane
    EXPECT_TRUE(world.isSolid({x, y, kCeiling}));
  }
}

/** A fan of level rays at a body's face, whose middle one meets it at a right angle. */
struct Look
{
  std::string body;
  TPoint3D eye;
  double yaw;    //!< [degrees]
  double angle;  //!< of the fan [degrees]
};

/** How many rays of a fan went which way, and how many should by Schlick's approximation. */
struct Ways
{
  std::size_t rays = 0, mirrored = 0, returned = 0;  //!< returned: by the body itself
  double mirroredRight = 0, mirroredVariance = 0, returnedRight = 0, returnedVariance = 0;
  std::vector<TPoint2D> ghosts;  //!< where they seem to be [m]
};

constexpr int kRays = 20001;
constexpr std::uint64_t kSeed = 3;

Scan scanOf(const Look& look)
{
  const mrpt::config::CConfigFileMemory ini(
      "[sensor.eye]\nkind = scanner2D\nrate = 1\nmaxRange = 100\nminRange = 0.01\nrays = " +
      std::to_string(kRays) + "\nfieldOfView = " + std::to_string(look.angle));
  params::StrictSection section(ini, "sensor.eye");
  const RayCaster caster(office().world);
  const mrpt::poses::CPose3D pose(look.eye.x, look.eye.y, look.eye.z, look.yaw * kDegree, 0, 0);
  return readSensor(section)->scan(caster, pose, kSeed);
}

Ways waysOf(const Look& look)
{
  const auto body = bodiesNamed(look.body).at(0);
  const Primitive& primitive = office().world.primitive(body);
  const Scan scan = scanOf(look);
  const auto& ranges = dynamic_cast<const mrpt::obs::CObservation2DRangeScan&>(*scan.observation);
  Ways ways;
  ways.rays = scan.bodies.size();
  for (std::size_t i = 0; i < ways.rays; ++i)
  {
    const double aside =
        look.angle * kDegree * (static_cast<double>(i) / static_cast<double>(kRays - 1) - 0.5);
    const double m = primitive.mirror();
    const double mirrored = m + (1 - m) * std::pow(1 - std::cos(aside), 5);
    const double returned = (1 - mirrored) * (1 - primitive.transparency());
    ways.mirroredRight += mirrored;
    ways.mirroredVariance += mirrored * (1 - mirrored);
    ways.returnedRight += returned;
    ways.returnedVariance += returned * (1 - returned);
    if (!scan.mirrored[i])
    {
      ways.returned += scan.bodies[i] == static_cast<std::int32_t>(body);
      continue;
    }
    ++ways.mirrored;
    const double range = static_cast<double>(ranges.getScanRange(i));
    const double towards = look.yaw * kDegree + aside;
    ways.ghosts.emplace_back(look.eye.x + range * std::cos(towards),
                             look.eye.y + range * std::sin(towards));
  }
  return ways;
}

const Look kWallCabinet{"box.cabinet_wall", {10.12, 8.2, 1.3}, -90, 50};
const Look kFreeCabinet{"box.cabinet_free", {18.57, 14.128, 1.3}, -67, 40};  // from the north
const Look kGlass{"pane.glass_meeting_2", {8.38, 8.0, 1.3}, 90, 40};
const Look kCeilingPane{"pane.ceiling_pane", {2.3, 8.0, 2.6}, 90, 40};

TEST(Office, GlassAndSteelMirrorAndReturnTheirShares)
{
  for (const Look& look : {kWallCabinet, kFreeCabinet, kGlass, kCeilingPane})
  {
    SCOPED_TRACE(look.body + ", seed " + std::to_string(kSeed));
    const Ways ways = waysOf(look);
    ASSERT_EQ(ways.rays, static_cast<std::size_t>(kRays));  // the office is closed
    EXPECT_NEAR(static_cast<double>(ways.mirrored), ways.mirroredRight,
                4 * std::sqrt(ways.mirroredVariance));
    EXPECT_NEAR(static_cast<double>(ways.returned), ways.returnedRight,
                4 * std::sqrt(ways.returnedVariance));
  }
}

TEST(Office, GhostsOfTheCabinetAtTheWallLieBehindTheWall)
{
  const Ways ways = waysOf(kWallCabinet);
  ASSERT_GT(ways.ghosts.size(), 1000u);
  for (const auto& ghost : ways.ghosts) ASSERT_LT(ghost.y, 6.74) << ghost.asString();
}

TEST(Office, GhostsOfTheFreeCabinetStandInItsRoom)
{
  const Ways ways = waysOf(kFreeCabinet);
  std::vector<Solid> scratch;
  const auto inRoom = std::count_if(ways.ghosts.begin(), ways.ghosts.end(),
                                    [&](const TPoint2D& ghost)
                                    {
                                      return ghost.x > 17 && ghost.y > 9.4 && ghost.y < 12.4 &&
                                             isFree(ghost.x, ghost.y, kRobotHeight, scratch);
                                    });
  EXPECT_GT(inRoom, static_cast<std::ptrdiff_t>(ways.ghosts.size() / 2));
}
}  // namespace
