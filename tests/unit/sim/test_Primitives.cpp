#include <gtest/gtest.h>
#include <mrpt_mapconv/sim/RayCaster.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "WorldText.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim;
using mrpt_mapconv::test::solidsAt;
using mrpt_mapconv::test::worldOf;

void expectSolid(const World& world, double x, double y, const Solid& right)
{
  SCOPED_TRACE("at " + std::to_string(x) + " " + std::to_string(y));
  const auto solids = solidsAt(world, x, y);
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_NEAR(solids[0].bottom, right.bottom, 1e-9);
  EXPECT_NEAR(solids[0].top, right.top, 1e-9);
  EXPECT_NEAR(solids[0].slope, right.slope, 1e-9);
}
void expectNothing(const World& world, double x, double y)
{
  EXPECT_TRUE(solidsAt(world, x, y).empty()) << "at " << x << " " << y;
}

// --- each kind, worked out by hand

TEST(Primitives, Box)
{
  const World world = worldOf("[box.a]\nmin = 1 2 3\nmax = 2 4 6\n");
  expectSolid(world, 1.01, 3.99, {3, 6, 0});
  expectNothing(world, 0.99, 3);
  expectNothing(world, 1.5, 4.01);
}

TEST(Primitives, BoxTurnedAboutItsCentre)
{
  // 4 x 2 about (0, 0), turned by 90 degrees: 2 x 4
  const World across = worldOf("[box.a]\nmin = -2 -1 0\nmax = 2 1 1\nyaw = 90\n");
  expectSolid(across, 0.9, 1.9, {0, 1, 0});
  expectNothing(across, 1.9, 0.9);
  // by 30 degrees the long axis points to (cos 30, sin 30)
  const World turned = worldOf("[box.a]\nmin = -2 -1 0\nmax = 2 1 1\nyaw = 30\n");
  expectSolid(turned, 1.99 * std::sqrt(0.75), 1.99 * 0.5, {0, 1, 0});
  expectNothing(turned, 1.99 * std::sqrt(0.75), -1.99 * 0.5);
}

TEST(Primitives, Ramp)
{
  const std::string corners = "min = 0 0 1\nmax = 4 2 3\n";
  expectSolid(worldOf("[ramp.a]\ndirection = +x\n" + corners), 1, 1, {1, 1.5, 0.5});
  expectSolid(worldOf("[ramp.a]\ndirection = -x\n" + corners), 1, 1, {1, 2.5, 0.5});
  expectSolid(worldOf("[ramp.a]\ndirection = +y\n" + corners), 1, 0.5, {1, 1.5, 1});
  expectSolid(worldOf("[ramp.a]\ndirection = -y\n" + corners), 1, 0.5, {1, 2.5, 1});
  expectNothing(worldOf("[ramp.a]\ndirection = -y\n" + corners), 1, 2.01);
}

TEST(Primitives, Stairs)
{
  const std::string keys = "min = 0 0 1\nmax = 4 2 3\nsteps = 4\n";  // 1 m deep, 0.5 m high
  const World right = worldOf("[stairs.a]\ndirection = +x\n" + keys);
  expectSolid(right, 0.01, 1, {1, 1.5, 0});
  expectSolid(right, 0.99, 1, {1, 1.5, 0});
  expectSolid(right, 1.01, 1, {1, 2.0, 0});
  expectSolid(right, 4.0, 1, {1, 3.0, 0});
  expectSolid(worldOf("[stairs.a]\ndirection = -x\n" + keys), 0.99, 1, {1, 3, 0});
  expectSolid(worldOf("[stairs.a]\ndirection = +y\n" + keys), 1, 0.6, {1, 2, 0});
  expectSolid(worldOf("[stairs.a]\ndirection = -y\n" + keys), 1, 0.6, {1, 2.5, 0});
}

TEST(Primitives, Cylinder)
{
  const World world = worldOf("[cylinder.a]\nbase = 1 2 3\nradius = 0.5\nheight = 2\n");
  expectSolid(world, 1.35, 2.35, {3, 5, 0});  // at 0.495 from the axis
  expectNothing(world, 1.36, 2.36);
}

TEST(Primitives, Sphere)
{
  const World world = worldOf("[sphere.a]\ncentre = 1 2 3\nradius = 5\n");
  expectSolid(world, 1, 2, {-2, 8, 0});
  expectSolid(world, 4, 2, {-1, 7, 0.75});  // 3-4-5
  expectNothing(world, 6.01, 2);
}

TEST(Primitives, Pane)
{
  const World world = worldOf(
      "[pane.a]\nfrom = 0 0\nto = 3 4\nbottom = 0.5\ntop = 2\nthickness = 0.1\n"
      "transparency = 0.8\n");
  EXPECT_DOUBLE_EQ(world.primitive(0).transparency(), 0.8);
  const double nx = -0.8, ny = 0.6;  // across the pane
  expectSolid(world, 1.5 + 0.049 * nx, 2 + 0.049 * ny, {0.5, 2, 0});
  expectNothing(world, 1.5 + 0.051 * nx, 2 + 0.051 * ny);
  expectNothing(world, 3.01, 4.02);
}

TEST(Primitives, OnlyMirrorsReflect)
{
  const std::string box = "[box.a]\nmin = 0 0 0\nmax = 1 1 1\n";
  const std::string pane = "[pane.a]\nfrom = 0 0\nto = 3 4\nbottom = 0.5\ntop = 2\n";
  for (const auto& body : {box, pane})
  {
    EXPECT_EQ(worldOf(body).primitive(0).mirror(), 0);
    EXPECT_EQ(worldOf(body + "mirror = 0.06\n").primitive(0).mirror(), 0.06);
    EXPECT_EQ(worldOf(body + "mirror = 1\n").primitive(0).transparency(), 0);
  }
}

// its walk is test_People's
TEST(Primitives, PersonIsACylinderThatIsNowhereForLong)
{
  const World world = worldOf("[person.a]\npath = 1 2  1 9\nspeed = 1\nbase = 3\n");
  const Primitive& person = world.primitive(0);
  EXPECT_NE(person.curved(), nullptr);
  EXPECT_NE(person.motion(), nullptr);
  expectNothing(world, 1, 2);
  Mesh mesh;
  person.appendMesh(mesh);
  for (const auto& [x, y, z] : mesh.vertices)
  {
    EXPECT_NEAR(std::hypot(x - 1, y - 2), 0.2, 1e-6);
    EXPECT_TRUE(z == 3 || z == 4.75f) << z;
  }
  EXPECT_EQ(worldOf("[cylinder.a]\nbase = 1 2 3\nradius = 1\nheight = 1\n").primitive(0).motion(),
            nullptr);
}

TEST(Primitives, PaneIsOpaqueAndOneCentimetreThickByDefault)
{
  const World world = worldOf("[pane.a]\nfrom = 0 0\nto = 0 2\nbottom = 0\ntop = 1\n");
  EXPECT_EQ(world.primitive(0).transparency(), 0);
  expectSolid(world, 0.0049, 1, {0, 1, 0});
  expectNothing(world, 0.0051, 1);
}

TEST(Primitives, TiltedHeightField)
{
  const std::string keys = "min = 0 0\nmax = 10 8\ncell = 3\nbase = 1\ngradient = 0.3 0.4\n";
  const World below = worldOf("[heightField.a]\nsolid = below\ndepth = 2\n" + keys);
  const auto ground = solidsAt(below, 2.2, 3.3);
  ASSERT_EQ(ground.size(), 1u);
  EXPECT_NEAR(ground[0].top, 1 + 0.66 + 1.32, 1e-6);  // heights are kept in single precision
  EXPECT_NEAR(ground[0].bottom, 1 - 2, 1e-6);         // below the lowest corner
  EXPECT_NEAR(ground[0].slope, 0.5, 1e-6);
  expectNothing(below, 10.01, 1);

  const World above = worldOf("[heightField.a]\nsolid = above\ndepth = 2\n" + keys);
  const auto rock = solidsAt(above, 2.2, 3.3);
  ASSERT_EQ(rock.size(), 1u);
  EXPECT_NEAR(rock[0].bottom, 1 + 0.66 + 1.32, 1e-6);
  EXPECT_NEAR(rock[0].top, 1 + 3 + 3.2 + 2, 1e-6);
  EXPECT_EQ(rock[0].slope, 0);
}

TEST(Primitives, NoiseStaysWithinItsAmplitudeAndDependsOnTheSeed)
{
  const auto fieldOf = [](int seed)
  {
    return worldOf("[heightField.a]\nmin = -20 -20\nmax = 20 20\ncell = 0.5\nsolid = below\n" +
                   std::string("amplitude = 2\nwavelength = 5\noctaves = 2\nseed = ") +
                   std::to_string(seed));
  };
  const World one = fieldOf(1), again = fieldOf(1), two = fieldOf(2);
  double low = 9, high = -9;
  bool differs = false;
  for (int i = 0; i < 44; ++i)
    for (int j = 0; j < 44; ++j)
    {
      const double x = -19.7 + 0.9 * i, y = -19.7 + 0.9 * j;
      const double z = solidsAt(one, x, y)[0].top;
      low = std::min(low, z);
      high = std::max(high, z);
      EXPECT_EQ(z, solidsAt(again, x, y)[0].top);
      differs = differs || z != solidsAt(two, x, y)[0].top;
    }
  EXPECT_TRUE(differs);
  EXPECT_GE(low, -3);  // 2 + 1
  EXPECT_LE(high, 3);
  EXPECT_GT(high - low, 2);
}

TEST(Primitives, TunnelThroughRock)
{
  // lattice points every 0.5 m, the tunnel along y = 0
  const World world = worldOf(
      "[heightField.rock]\nmin = -10 -5\nmax = 10 5\ncell = 0.5\nsolid = above\nbase = 1\n"
      "arch_1 = -8 0  8 0\narchWidth = 4\narchHeight = 3\nwallBottom = -2\n");
  const auto bottomAt = [&](double x, double y) { return solidsAt(world, x, y).at(0).bottom; };
  EXPECT_NEAR(bottomAt(0, 0), 1 + 3, 1e-6);
  EXPECT_NEAR(bottomAt(0, 1), 1 + 3 * std::sqrt(1 - std::pow(0.5, 4)), 1e-6);
  EXPECT_NEAR(bottomAt(0, 2), -2, 1e-6);   // the wall
  EXPECT_NEAR(bottomAt(0, -4), -2, 1e-6);  // and the rock behind
  EXPECT_NEAR(bottomAt(9, 0), 1 + 3 * std::sqrt(1 - std::pow(0.5, 4)), 1e-6);  // a round end
  EXPECT_NEAR(bottomAt(10, 0), -2, 1e-6);
}

TEST(Primitives, KindsAreNamedInOrder)
{
  const std::vector<std::string> names{
      "box",    "canopy", "chair", "cylinder", "forest", "heightField", "log",   "pane",
      "person", "ramp",   "shelf", "sphere",   "stairs", "table",       "trunk", "undergrowth"};
  EXPECT_EQ(PrimitiveKind::names(), names);
  EXPECT_EQ(PrimitiveKind::find("Box"), nullptr);
}

// --- what rays see is what the truth says

/** Goes through a body along a vertical line by rays, which meet all of its faces. */
std::vector<double> facesAlong(const RayCaster& caster, double x, double y)
{
  std::vector<double> faces;
  float z = -9.5f;
  for (;;)
  {
    const Hit hit = caster.cast({{float(x), float(y), z}, {0, 0, 1}}, 0, 100);
    if (hit.primitive < 0) return faces;
    faces.push_back(z + hit.range);
    z += hit.range + 1e-4f;
  }
}

void expectRaysSeeTheSolids(const std::string& body)
{
  SCOPED_TRACE(body);
  const World world = worldOf("[" + body);
  const RayCaster caster(world);
  const Footprint area = world.primitive(0).footprint();
  std::mt19937 random(7);
  std::uniform_real_distribution<float> x(float(area.xMin) - 0.2f, float(area.xMax) + 0.2f),
      y(float(area.yMin) - 0.2f, float(area.yMax) + 0.2f);
  int inside = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const float px = x(random), py = y(random);
    const auto solids = solidsAt(world, px, py);
    const auto faces = facesAlong(caster, px, py);
    if (!solids.empty() && solids[0].top - solids[0].bottom < 0.01) continue;  // a sharp edge
    // at the very rim, single precision may decide otherwise
    bool rim = false;
    for (const double d : {-1e-4, 1e-4})
      rim = rim || solidsAt(world, px + d, py).size() != solids.size() ||
            solidsAt(world, px, py + d).size() != solids.size();
    if (rim) continue;
    ASSERT_EQ(faces.size(), 2 * solids.size()) << "ray " << i << " at " << px << " " << py;
    if (solids.empty()) continue;
    ++inside;
    const double slack = solids[0].slope > 5 ? 1e-3 : 2e-5;
    // stairs: near a riser it is decided by rounding which tread is met
    ASSERT_NEAR(faces[0], solids[0].bottom, slack) << "ray " << i << " at " << px << " " << py;
    ASSERT_NEAR(faces[1], solids[0].top, slack) << "ray " << i << " at " << px << " " << py;
  }
  EXPECT_GT(inside, 1000);
}

TEST(Primitives, RaysSeeTheSolids)
{
  expectRaysSeeTheSolids("box.a]\nmin = -1 -2 0.3\nmax = 2 3 1.7\nyaw = 35\n");
  for (const char* direction : {"+x", "-x", "+y", "-y"})
  {
    const std::string keys = std::string("direction = ") + direction + "\nmin = -1 -2 0.3\n";
    expectRaysSeeTheSolids("ramp.a]\n" + keys + "max = 4 3 1.7\n");
    expectRaysSeeTheSolids("stairs.a]\n" + keys + "max = 4 3 1.7\nsteps = 5\n");
  }
  expectRaysSeeTheSolids("cylinder.a]\nbase = 1 2 -1\nradius = 1.5\nheight = 3\n");
  expectRaysSeeTheSolids("sphere.a]\ncentre = 1 2 3\nradius = 1.5\n");
  expectRaysSeeTheSolids(
      "pane.a]\nfrom = -1 -2\nto = 3 1\nbottom = 0.2\ntop = 2\nthickness = 2.5\n");
  const std::string field =
      "heightField.a]\nmin = -6 -4\nmax = 5 7\ncell = 0.3\namplitude = 1\nwavelength = 3\n"
      "octaves = 3\n";
  expectRaysSeeTheSolids(field + "solid = below\n");
  expectRaysSeeTheSolids(field + "solid = above\n");
  expectRaysSeeTheSolids(field +
                         "solid = above\nbase = 1\narch_1 = -6 0 1 2 2 7\narchWidth = 3\n"
                         "archHeight = 2.5\nwallBottom = -2.5\n");
}

TEST(Primitives, MeshesOfCurvedBodiesComeNearTheirSurface)
{
  const World world = worldOf(
      "[sphere.a]\ncentre = 1 2 3\nradius = 2\n[cylinder.b]\nbase = 4 5 6\nradius = 2\n"
      "height = 3\n");
  for (std::size_t i = 0; i < world.size(); ++i)
  {
    const bool sphere = world.name(i) == "sphere.a";
    Mesh mesh;
    world.primitive(i).appendMesh(mesh);
    ASSERT_FALSE(mesh.triangles.empty());
    for (const auto& [x, y, z] : mesh.vertices)
    {
      EXPECT_NEAR(sphere ? std::hypot(x - 1, std::hypot(y - 2, z - 3)) : std::hypot(x - 4, y - 5),
                  2, 1e-5);
      EXPECT_TRUE(sphere || z == 6 || z == 9) << z;
    }
  }
}

// --- bad worlds

struct BadBody
{
  const char *text, *error;
};

class BadBodies : public testing::TestWithParam<BadBody>
{
};

TEST_P(BadBodies, GetAnErrorThatNamesSectionAndKey)
{
  try
  {
    worldOf(GetParam().text);
    FAIL() << "no error for " << GetParam().text;
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(error.what(), GetParam().error);
  }
}

const BadBody kBadBodies[] = {
    {"[box.a]\nmin = 0 0 0\n",
     "section 'box.a': max = '' is not valid: it must be given: three numbers, x y z [m]"},
    {"[box.a]\nmin = 0 0 0\nmax = 1 1\n",
     "section 'box.a': max = '1 1' is not valid: it must be three numbers, x y z [m]"},
    {"[box.a]\nmin = 0 0 0\nmax = 1 -1 1\n",
     "section 'box.a': max = '1 -1 1' is not valid: it must be above min in y"},
    {"[box.a]\nmin = 0 0 0\nmax = 1 1 0\n",
     "section 'box.a': max = '1 1 0' is not valid: it must be above min in z"},
    {"[box.a]\nmin = 0 0 0\nmax = 1 1 1e9\n",
     "section 'box.a': max = '1 1 1e9' is not valid: it must be three numbers, x y z [m], within "
     "+-1e6"},
    {"[box.a]\nmin = 0 0 0\nmax = 1 1 1\nroll = 3\n",
     "section 'box.a': 'roll' is not a key of a box: correct its name or take it out"},
    {"[ramp.a]\nmin = 0 0 0\nmax = 1 1 1\n",
     "section 'ramp.a': direction = '' is not valid: it must be given: +x or -x or +y or -y"},
    {"[ramp.a]\nmin = 0 0 0\nmax = 1 1 1\ndirection = up\n",
     "section 'ramp.a': direction = 'up' is not valid: it must be +x or -x or +y or -y"},
    {"[stairs.a]\nmin = 0 0 0\nmax = 1 1 1\ndirection = +x\n",
     "section 'stairs.a': steps = '' is not valid: it must be given: the number of steps"},
    {"[stairs.a]\nmin = 0 0 0\nmax = 1 1 1\ndirection = +x\nsteps = 0\n",
     "section 'stairs.a': steps = '0' is not valid: it must be within 1 and 10000"},
    {"[cylinder.a]\nbase = 0 0 0\nradius = -1\nheight = 1\n",
     "section 'cylinder.a': radius = '-1' is not valid: it must be a number > 0"},
    {"[cylinder.a]\nbase = 0 0 0\nradius = 1\nheight = 0\n",
     "section 'cylinder.a': height = '0' is not valid: it must be a number > 0"},
    {"[sphere.a]\ncentre = 0 0 0\nradius = 0\n",
     "section 'sphere.a': radius = '0' is not valid: it must be a number > 0"},
    {"[sphere.a]\ncentre = 0 0 zero\nradius = 1\n",
     "section 'sphere.a': centre = '0 0 zero' is not valid: it must be a list of finite numbers"},
    {"[pane.a]\nfrom = 1 1\nto = 1 1\nbottom = 0\ntop = 1\n",
     "section 'pane.a': to = '1 1' is not valid: it must be another place than from"},
    {"[pane.a]\nfrom = 1 1\nto = 1 2\nbottom = 1\ntop = 1\n",
     "section 'pane.a': top = '1' is not valid: it must be above bottom"},
    {"[pane.a]\nfrom = 1 1\nto = 1 2\nbottom = 0\ntop = 1\nthickness = 0\n",
     "section 'pane.a': thickness = '0' is not valid: it must be a number > 0"},
    {"[pane.a]\nfrom = 1 1\nto = 1 2\nbottom = 0\ntop = 1\ntransparency = 1.1\n",
     "section 'pane.a': transparency = '1.1' is not valid: it must be within 0 and 1"},
    {"[pane.a]\nfrom = 1 1\nto = 1 2\nbottom = 0\ntop = 1\nmirror = -0.1\n",
     "section 'pane.a': mirror = '-0.1' is not valid: it must be within 0 and 1"},
    {"[box.a]\nmin = 0 0 0\nmax = 1 1 1\nmirror = 1.1\n",
     "section 'box.a': mirror = '1.1' is not valid: it must be within 0 and 1"},
    {"[box.a]\nmin = 0 0 0\nmax = 1 1 1\nmirror = steel\n",
     "section 'box.a': mirror = 'steel' is not valid: it must be a finite number"},
    {"[sphere.a]\ncentre = 0 0 0\nradius = 1\nmirror = 1\n",
     "section 'sphere.a': 'mirror' is not a key of a sphere: correct its name or take it out"},
    {"[person.a]\nspeed = 1\n",
     "section 'person.a': path = '' is not valid: it must be given: two or more points, x y x y "
     "... "
     "[m]"},
    {"[person.a]\nspeed = 1\npath = 1 2\n",
     "section 'person.a': path = '1 2' is not valid: it must be two or more points, x y x y ... "
     "[m]"},
    {"[person.a]\nspeed = 1\npath = 1 2 3 4 5\n",
     "section 'person.a': path = '1 2 3 4 5' is not valid: it must be two or more points, x y x y "
     "... [m]"},
    {"[person.a]\nspeed = 1\npath = 1 2 1e7 4\n",
     "section 'person.a': path = '1 2 1e7 4' is not valid: it must be two or more points, x y x y "
     "... [m], within +-1e6"},
    {"[person.a]\nspeed = 1\npath = 1 2 1 2\n",
     "section 'person.a': path = '1 2 1 2' is not valid: it must be a line that leads to another "
     "place"},
    {"[person.a]\npath = 1 2 3 4\n",
     "section 'person.a': speed = '' is not valid: it must be given: a number > 0"},
    {"[person.a]\nspeed = 0\npath = 1 2 3 4\n",
     "section 'person.a': speed = '0' is not valid: it must be a number > 0"},
    {"[person.a]\nspeed = 1\npath = 1 2 3 4\nheight = -1\n",
     "section 'person.a': height = '-1' is not valid: it must be a number > 0"},
    {"[person.a]\nspeed = 1\npath = 1 2 3 4\nradius = 0\n",
     "section 'person.a': radius = '0' is not valid: it must be a number > 0"},
    {"[person.a]\nspeed = 1\npath = 1 2 3 4\nbase = 2 3\n",
     "section 'person.a': base = '2 3' is not valid: it must be one number"},
    {"[person.a]\nspeed = 1\npath = 1 2 3 4\nstart = -1\n",
     "section 'person.a': start = '-1' is not valid: it must be a number >= 0 [s]"},
    {"[person.a]\nspeed = 1\npath = 1 2 3 4\nyaw = 3\n",
     "section 'person.a': 'yaw' is not a key of a person: correct its name or take it out"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 0\ncell = 1\nsolid = below\n",
     "section 'heightField.a': max = '1 0' is not valid: it must be above min in x and y"},
    {"[heightField.a]\nmin = 0 0\nmax = 100 100\ncell = 0.001\nsolid = below\n",
     "section 'heightField.a': cell = '0.001' is not valid: it must be so large that the field has "
     "at most 2e7 points"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\n",
     "section 'heightField.a': solid = '' is not valid: it must be given: below or above"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = below\ndepth = 0\n",
     "section 'heightField.a': depth = '0' is not valid: it must be a number > 0"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = below\namplitude = 1\n",
     "section 'heightField.a': wavelength = '' is not valid: it must be given: a number > 0"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = below\namplitude = -1\n",
     "section 'heightField.a': amplitude = '-1' is not valid: it must be a height >= 0 [m]"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = below\noctaves = 13\n",
     "section 'heightField.a': octaves = '13' is not valid: it must be within 1 and 12"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = below\narch_1 = 0 0 1 1\n"
     "archWidth = 1\narchHeight = 1\n",
     "section 'heightField.a': solid = 'below' is not valid: it must be above for tunnels (arch_1 "
     "...)"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = above\narch_1 = 0 0 1\n",
     "section 'heightField.a': arch_1 = '0 0 1' is not valid: it must be two or more points, x y x "
     "y ... [m]"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = above\narch_1 = 0 0 1 1\n"
     "archWidth = 1 2\narchHeight = 1\n",
     "section 'heightField.a': archWidth = '1 2' is not valid: it must be one number > 0 [m], or "
     "one for each arch"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = above\narch_1 = 0 0 1 1\n"
     "archWidth = 1\narchHeight = 1\n",
     "section 'heightField.a': wallBottom = '' is not valid: it must be given: one number"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = above\narch_2 = 0 0 1 1\n",
     "section 'heightField.a': 'arch_2' is not a key of a heightField: correct its name or take it "
     "out"},
};
INSTANTIATE_TEST_SUITE_P(Primitives, BadBodies, testing::ValuesIn(kBadBodies));
}  // namespace
