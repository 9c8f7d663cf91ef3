#include <algorithm>
#include <cmath>

#include "../Crown.h"
#include "../OnGround.h"
#include "../Random.h"
#include "../Timber.h"

namespace mrpt_mapconv::sim
{
namespace
{
using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;

constexpr double kMostTrees = 1e5;
constexpr int kTries = 1000;         //!< to find room for a tree or log
constexpr double kTopOfTrunk = 0.5;  //!< its radius at the crown's middle, of that at the foot
constexpr double kTurn = 2 * 3.14159265358979323846;

/** What all trees of a forest have in common. */
struct Trees
{
  std::size_t count = 0;
  double spacing = 0;
  Interval height, trunkRadius, crownRadius, crownBase;
  Leaves leaves;
};

/** Likewise its fallen trees. */
struct Logs
{
  std::size_t count = 0;
  Interval length, radius;
};

/** A number per hectare, of an area. */
std::size_t readCount(params::StrictSection& section, const std::string& key, const Outline& area)
{
  const double density = readNumber(section, key);
  const double count = std::round(density * area.size().x * area.size().y / 1e4);
  if (!(density >= 0 && count <= kMostTrees)) section.fail(key, "a number >= 0, for at most 1e5");
  return static_cast<std::size_t>(count);
}

Trees readTrees(params::StrictSection& section, const Outline& area)
{
  Trees trees;
  trees.count = readCount(section, "treesPerHectare", area);
  section.read("spacing", trees.spacing);
  if (trees.spacing < 0) section.fail("spacing", "a distance >= 0 [m]");
  trees.height = readInterval(section, "height");
  trees.trunkRadius = readInterval(section, "trunkRadius");
  trees.crownRadius = readInterval(section, "crownRadius");
  trees.crownBase = readInterval(section, "crownBase");
  if (!(trees.crownBase.high < 1)) section.fail("crownBase", "shares of the height, below 1");
  trees.leaves = Leaves::read(section);
  return trees;
}

Logs readLogs(params::StrictSection& section, const Outline& area)
{
  Logs logs;
  if (!section.has("logsPerHectare")) return logs;
  logs.count = readCount(section, "logsPerHectare", area);
  logs.length = readInterval(section, "logLength");
  logs.radius = readInterval(section, "logRadius");
  return logs;
}

/** Grows trees and lets some fall. */
class Forester
{
 public:
  Forester(params::StrictSection& section, const World& world, const Outline& area,
           std::uint32_t seed)
      : m_section(section), m_world(world), m_area(area), m_random(randomKey(seed, "forest", 0))
  {
  }

  Bodies work(const Trees& trees, const Logs& logs)
  {
    for (std::size_t i = 0; i < trees.count; ++i) grow(trees);
    for (std::size_t i = 0; i < logs.count; ++i) fell(logs);
    return std::move(m_bodies);
  }

 private:
  void grow(const Trees& trees)
  {
    const TPoint3D foot = onGround(placeApart(trees.spacing));
    const double height = draw(trees.height), base = height * draw(trees.crownBase);
    TrunkShape trunk;
    trunk.radius = draw(trees.trunkRadius);
    trunk.topRadius = kTopOfTrunk * trunk.radius;
    trunk.height = (base + height) / 2;
    m_bodies.push_back(trunkAt(m_world, foot, trunk));
    m_bodies.push_back(crownOver(foot, {base, height, draw(trees.crownRadius)}, trees.leaves));
  }

  void fell(const Logs& logs)
  {
    const double length = draw(logs.length), radius = draw(logs.radius);
    for (int i = 0; i < kTries; ++i)
    {
      const TPoint2D from = anywhere();
      const double direction = kTurn * m_random.uniform();
      const TPoint2D to(from.x + length * std::cos(direction),
                        from.y + length * std::sin(direction));
      if (!contains(to)) continue;
      m_bodies.push_back(logBetween(onGround(from), onGround(to), radius));
      return;
    }
    m_section.fail("logLength", "so small that logs find room in the area");
  }

  TPoint2D placeApart(double spacing)
  {
    for (int i = 0; i < kTries; ++i)
    {
      const TPoint2D place = anywhere();
      const auto isNear = [&](const TPoint2D& other)
      { return std::hypot(other.x - place.x, other.y - place.y) < spacing; };
      if (std::any_of(m_places.begin(), m_places.end(), isNear)) continue;
      m_places.push_back(place);
      return place;
    }
    m_section.fail("spacing", "so small that all trees find room in the area");
  }

  TPoint2D anywhere()
  {
    const double x = m_area.min.x + m_random.uniform() * m_area.size().x;
    return {x, m_area.min.y + m_random.uniform() * m_area.size().y};
  }
  bool contains(const TPoint2D& p) const
  {
    return p.x >= m_area.min.x && p.x <= m_area.max.x && p.y >= m_area.min.y && p.y <= m_area.max.y;
  }
  double draw(const Interval& interval) { return interval.at(m_random.uniform()); }

  TPoint3D onGround(const TPoint2D& place) const
  {
    const auto z = m_world.groundAt(place.x, place.y);
    if (!z)
      m_section.fail("max", "such that there is ground (of a heightField) in all of the area");
    return {place.x, place.y, *z};
  }

  params::StrictSection& m_section;
  const World& m_world;
  Outline m_area;
  Random m_random;
  std::vector<TPoint2D> m_places;  // of trees
  Bodies m_bodies;
};

/** Trees, and trees that have fallen, at random in a rectangle. min, max: its corners, x y [m];
 * treesPerHectare; spacing: least distance of their middles [m], default 0; height, trunkRadius (at
 * the foot), crownRadius: lowest and highest [m]; crownBase: likewise, where crowns begin, as a
 * share of the height; density, solid: of the crowns, see Leaves; logsPerHectare: default 0, with
 * logLength and logRadius: lowest and highest [m]; seed. */
Bodies readForest(params::StrictSection& section, const World& world)
{
  const Outline area = readOutline(section);
  const Trees trees = readTrees(section, area);
  const Logs logs = readLogs(section, area);
  std::uint32_t seed = 1;
  section.read("seed", seed);
  return Forester(section, world, area, seed).work(trees, logs);
}

const PrimitiveKind kKind("forest", readForest);
}  // namespace
}  // namespace mrpt_mapconv::sim
