#include <gtest/gtest.h>
#include <mrpt_mapconv/sim/RayCaster.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "WorldText.h"

// Tables, chairs and shelves: one body each, of upright boxes.
namespace
{
using namespace mrpt_mapconv::sim;
using mrpt_mapconv::test::solidsAt;
using mrpt_mapconv::test::worldOf;

/** The solids over a place; what is in `right` are their bottoms and tops, from the lowest up. */
void expectSolids(const World& world, double x, double y, const std::vector<double>& right)
{
  SCOPED_TRACE("at " + std::to_string(x) + " " + std::to_string(y));
  const auto solids = solidsAt(world, x, y);
  ASSERT_EQ(solids.size(), right.size() / 2);
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    EXPECT_NEAR(solids[i].bottom, right[2 * i], 1e-9);
    EXPECT_NEAR(solids[i].top, right[2 * i + 1], 1e-9);
    EXPECT_EQ(solids[i].slope, 0);
  }
}

// --- each kind, worked out by hand

TEST(Furniture, Table)
{
  const World world = worldOf("[table.a]\nmin = 1 2\nmax = 2.6 2.8\n");
  expectSolids(world, 1.8, 2.4, {0.71, 0.74});  // under it there is room
  for (const double x : {1.049, 2.551})
    for (const double y : {2.049, 2.751}) expectSolids(world, x, y, {0, 0.74});  // legs
  expectSolids(world, 1.051, 2.01, {0.71, 0.74});
  expectSolids(world, 2.549, 2.79, {0.71, 0.74});
  expectSolids(world, 0.999, 2.4, {});
  expectSolids(world, 1.8, 2.801, {});
}

TEST(Furniture, TableOfOtherMeasuresOnAPlatform)
{
  const World world = worldOf(
      "[table.a]\nmin = -1 -0.5\nmax = 1 0.5\nheight = 1.1\nthickness = 0.1\nleg = 0.2\n"
      "base = 2\nyaw = 90\n");
  expectSolids(world, 0, 0, {3, 3.1});
  expectSolids(world, 0.31, 0.81, {2, 3.1});  // turned: 1 m along x, 2 m along y
  expectSolids(world, 0.29, 0.81, {3, 3.1});
  expectSolids(world, 0.31, 0.79, {3, 3.1});
  expectSolids(world, 0.51, 0, {});
  expectSolids(world, 0.49, 0.99, {2, 3.1});
}

TEST(Furniture, Chair)
{
  const World world = worldOf("[chair.a]\ncentre = 3 5\n");
  expectSolids(world, 3, 5, {0.41, 0.45});
  expectSolids(world, 3.219, 5.219, {0, 0.45});  // legs
  expectSolids(world, 3.194, 5.219, {0.41, 0.45});
  expectSolids(world, 2.781, 4.781, {0, 0.9});  // and those under the back
  expectSolids(world, 2.809, 5, {0.41, 0.9});   // the back, 3 cm thick
  expectSolids(world, 2.811, 5, {0.41, 0.45});
  expectSolids(world, 3.221, 5, {});
}

TEST(Furniture, AChairLooksWhereItsYawSays)
{
  const World world = worldOf("[chair.a]\ncentre = 3 5\nyaw = -90\nseat = 0.5\nheight = 1\n");
  expectSolids(world, 3, 5.2, {0.46, 1});  // it looks to -y
  expectSolids(world, 3, 4.8, {0.46, 0.5});
}

/** A shelf of 1.2 m width and 0.4 m depth about (0, 0), with three boards. */
World shelfTowards(const std::string& direction, const std::string& more = "")
{
  const std::string corners =
      direction[1] == 'y' ? "min = -0.6 -0.2\nmax = 0.6 0.2\n" : "min = -0.2 -0.6\nmax = 0.2 0.6\n";
  return worldOf("[shelf.a]\n" + corners + "direction = " + direction +
                 "\nheight = 1.105\nboards = 3\n" + more);
}

TEST(Furniture, Shelf)
{
  // (across, deep): seen by who looks into it
  const std::vector<double> boards{0.08, 0.105, 0.58, 0.605, 1.08, 1.105}, all{0, 1.105};
  for (const char* direction : {"+x", "-x", "+y", "-y"})
  {
    SCOPED_TRACE(direction);
    const World world = shelfTowards(direction);
    const double sign = direction[0] == '-' ? -1 : 1;
    const auto expect = [&](double across, double deep, const std::vector<double>& right)
    {
      const bool alongY = direction[1] == 'y';
      expectSolids(world, alongY ? across : sign * deep, alongY ? sign * deep : across, right);
    };
    expect(0, 0, boards);
    expect(0.574, 0.199, boards);  // the front is open
    expect(0, -0.174, boards);     // the back is 2.5 cm thick
    expect(0, -0.176, all);
    expect(0.576, 0, all);  // and so are the sides
    expect(-0.576, 0.199, all);
    expect(0.601, 0, {});
    expect(0, 0.201, {});
  }
}

TEST(Furniture, ATurnedShelf)
{
  const World world = shelfTowards("+y", "thickness = 0.05\nyaw = 180\n");
  expectSolids(world, 0, 0.151, {0, 1.105});  // the back
  expectSolids(world, 0, 0.149, {0.08, 0.13, 0.5675, 0.6175, 1.055, 1.105});
}

// --- what rays see is what the truth says

const char* const kFurniture[] = {
    "table.a]\nmin = 1 2\nmax = 2.6 2.8\nyaw = 17\n",
    "table.a]\nmin = -1 -0.5\nmax = 1 0.5\nheight = 0.5\nthickness = 0.2\nleg = 0.5\nbase = 0.3\n",
    "chair.a]\ncentre = 3 5\nyaw = -123\n",
    "chair.a]\ncentre = 3 5\nsize = 0.6\nseat = 0.6\nheight = 1.4\nleg = 0.3\nbase = -0.4\n",
    "shelf.a]\nmin = 1 2\nmax = 2.6 2.4\ndirection = -y\nyaw = 8\n",
    "shelf.a]\nmin = 1 2\nmax = 1.3 2.9\ndirection = +x\nheight = 0.8\nboards = 2\nyaw = -40\n"};

/** What a ray is cast at. */
struct Box
{
  mrpt::math::TPoint3D min, max;

  mrpt::math::TPoint3D at(double u, double v, double w) const
  {
    return {min.x + u * (max.x - min.x), min.y + v * (max.y - min.y), min.z + w * (max.z - min.z)};
  }
};

Box boxAround(const Primitive& body)
{
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Box box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  Mesh mesh;
  body.appendMesh(mesh);
  for (const auto& vertex : mesh.vertices)
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double place = static_cast<double>(vertex[axis]);
      box.min[axis] = std::min(box.min[axis], place);
      box.max[axis] = std::max(box.max[axis], place);
    }
  return box;
}

bool isInside(const Primitive& body, const mrpt::math::TPoint3D& point, std::vector<Solid>& scratch)
{
  scratch.clear();
  body.appendSolids(point.x, point.y, scratch);
  return std::any_of(scratch.begin(), scratch.end(),
                     [&](const Solid& solid)
                     { return solid.bottom <= point.z && point.z <= solid.top; });
}

/** Walks along a ray and says how far it is to the first place inside [m]; infinite: none. */
double walkedRange(const Primitive& body, const Ray& ray, double step)
{
  std::vector<Solid> scratch;
  for (int i = 0; i * step < 6; ++i)
  {
    const double range = i * step;
    const auto way = mrpt::math::TPoint3D(ray.direction) * range;
    if (isInside(body, mrpt::math::TPoint3D(ray.origin) + way, scratch)) return range;
  }
  return std::numeric_limits<double>::infinity();
}

/** A ray from a sphere around a body, through a place in the box around it or beside it. */
Ray randomRay(const Box& box, std::mt19937& random)
{
  std::uniform_real_distribution<double> share(-0.4, 1.4);
  std::normal_distribution<double> normal;
  const mrpt::math::TPoint3D outwards(normal(random), normal(random), normal(random));
  const auto origin = box.at(0.5, 0.5, 0.5) + outwards.unitarize() * 2.5;
  const auto target = box.at(share(random), share(random), share(random));
  return {mrpt::math::TPoint3Df(origin), mrpt::math::TPoint3Df((target - origin).unitarize())};
}

TEST(Furniture, RaysFromAllSidesMeetTheSolids)
{
  constexpr double kStep = 0.002;
  for (const std::string furniture : kFurniture)
  {
    SCOPED_TRACE(furniture);
    const World world = worldOf("[" + furniture);
    const Primitive& body = world.primitive(0);
    const Box box = boxAround(body);
    const RayCaster caster(world);
    constexpr unsigned kSeed = 11;
    std::mt19937 random(kSeed);
    std::vector<Solid> scratch;
    int met = 0, missed = 0;
    for (int i = 0; i < 2000; ++i)
    {
      const Ray ray = randomRay(box, random);
      const Hit hit = caster.cast(ray, 0, 6);
      const double walked = walkedRange(body, ray, kStep);
      // steps can pass over an edge that is met, but not be inside of what is not
      const double range = static_cast<double>(hit.range);
      ASSERT_LE(range, walked + 1e-5) << "seed " << kSeed << ", ray " << i;
      ++(hit.primitive < 0 ? missed : met);
      if (hit.primitive < 0) continue;
      const auto along = [&](double r)
      { return mrpt::math::TPoint3D(ray.origin) + mrpt::math::TPoint3D(ray.direction) * r; };
      bool touches = isInside(body, along(range), scratch);
      for (int corner = 0; corner < 8 && !touches; ++corner)
      {
        const mrpt::math::TPoint3D aside((corner & 1 ? 1 : -1) * 1e-5, (corner & 2 ? 1 : -1) * 1e-5,
                                         (corner & 4 ? 1 : -1) * 1e-5);
        touches = isInside(body, along(range) + aside, scratch);
      }
      ASSERT_TRUE(touches) << "seed " << kSeed << ", ray " << i << " at "
                           << along(range).asString();
    }
    EXPECT_GT(met, 300);
    EXPECT_GT(missed, 300);
  }
}

TEST(Furniture, FootprintsHoldTheBodyTightly)
{
  for (const std::string furniture : kFurniture)
  {
    SCOPED_TRACE(furniture);
    const World world = worldOf("[" + furniture);
    const Footprint area = world.primitive(0).footprint();
    const Box box = boxAround(world.primitive(0));
    EXPECT_NEAR(area.xMin, box.min.x, 1e-6);
    EXPECT_NEAR(area.yMin, box.min.y, 1e-6);
    EXPECT_NEAR(area.xMax, box.max.x, 1e-6);
    EXPECT_NEAR(area.yMax, box.max.y, 1e-6);
  }
}

// --- bad furniture

struct BadPiece
{
  const char *text, *error;
};

class BadFurniture : public testing::TestWithParam<BadPiece>
{
};

TEST_P(BadFurniture, GetsAnErrorThatNamesSectionAndKey)
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

const BadPiece kBadPieces[] = {
    {"[table.a]\nmin = 0 0\n",
     "section 'table.a': max = '' is not valid: it must be given: two numbers, x y [m]"},
    {"[table.a]\nmin = 0 0 0\nmax = 1 1\n",
     "section 'table.a': min = '0 0 0' is not valid: it must be two numbers, x y [m]"},
    {"[table.a]\nmin = 0 0\nmax = 1 0\n",
     "section 'table.a': max = '1 0' is not valid: it must be above min in x and y"},
    {"[table.a]\nmin = 0 0\nmax = 1 1\nheight = 0\n",
     "section 'table.a': height = '0' is not valid: it must be a number > 0"},
    {"[table.a]\nmin = 0 0\nmax = 1 1\nthickness = 0.74\n",
     "section 'table.a': thickness = '0.74' is not valid: it must be below the height"},
    {"[table.a]\nmin = 0 0\nmax = 1 0.5\nleg = 0.26\n",
     "section 'table.a': leg = '0.26' is not valid: it must be at most half of each side"},
    {"[table.a]\nmin = 0 0\nmax = 1 1\nbase = low\n",
     "section 'table.a': base = 'low' is not valid: it must be a list of finite numbers"},
    {"[table.a]\nmin = 0 0\nmax = 1 1\nlegs = 3\n",
     "section 'table.a': 'legs' is not a key of a table: correct its name or take it out"},
    {"[chair.a]\nyaw = 3\n",
     "section 'chair.a': centre = '' is not valid: it must be given: two numbers, x y [m]"},
    {"[chair.a]\ncentre = 0 0\nsize = 0.05\n",
     "section 'chair.a': size = '0.05' is not valid: it must be at least 0.06"},
    {"[chair.a]\ncentre = 0 0\nseat = 0.04\n",
     "section 'chair.a': seat = '0.04' is not valid: it must be above 0.04, the seat's thickness"},
    {"[chair.a]\ncentre = 0 0\nheight = 0.45\n",
     "section 'chair.a': height = '0.45' is not valid: it must be above the seat"},
    {"[chair.a]\ncentre = 0 0\nleg = 0.23\n",
     "section 'chair.a': leg = '0.23' is not valid: it must be at most half of the size"},
    {"[chair.a]\ncentre = 0 0\nyaw = left\n",
     "section 'chair.a': yaw = 'left' is not valid: it must be a finite number"},
    {"[shelf.a]\nmin = 0 0\nmax = 1 0.4\n",
     "section 'shelf.a': direction = '' is not valid: it must be given: +x or -x or +y or -y"},
    {"[shelf.a]\nmin = 0 0\nmax = 1 0.4\ndirection = -y\nboards = 1\n",
     "section 'shelf.a': boards = '1' is not valid: it must be within 2 and 100"},
    {"[shelf.a]\nmin = 0 0\nmax = 1 0.4\ndirection = -y\nthickness = 0.2\n",
     "section 'shelf.a': thickness = '0.2' is not valid: it must be below half of each side"},
    {"[shelf.a]\nmin = 0 0\nmax = 1 0.4\ndirection = -y\nheight = 0.2\n",
     "section 'shelf.a': height = '0.2' is not valid: it must be above that of a foot of 0.08 m "
     "and all boards"},
};
INSTANTIATE_TEST_SUITE_P(Furniture, BadFurniture, testing::ValuesIn(kBadPieces));
}  // namespace
