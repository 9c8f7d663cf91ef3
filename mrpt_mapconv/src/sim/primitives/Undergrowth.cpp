#include <algorithm>
#include <cmath>
#include <utility>

#include "../Crown.h"
#include "../MeshBuilder.h"
#include "../OnGround.h"
#include "../Random.h"
#include "../Tiling.h"

namespace mrpt_mapconv::sim
{
namespace
{
using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

constexpr double kMostTiles = 1e6;

/** Leaves over a square of ground, up to a height above it. */
struct Tile
{
  TPoint3D middle;    // on the ground [m]
  TPoint2D gradient;  // of the ground [m/m]
  TPoint2D half;      // of its sides [m]
  double height = 0;  // above the ground [m]

  double groundAt(double x, double y) const
  {
    return middle.z + gradient.x * (x - middle.x) + gradient.y * (y - middle.y);
  }
  /** How far the ground reaches up and down from the middle [m]. */
  double relief() const { return std::abs(gradient.x) * half.x + std::abs(gradient.y) * half.y; }
};

/** Leaves the part of a stretch in which start + way · speed is between 0 and width. */
bool clip(double start, double speed, double width, Stretch& stretch)
{
  if (speed == 0) return start >= 0 && start <= width;
  const double a = -start / speed, b = (width - start) / speed;
  stretch.from = std::max(stretch.from, std::min(a, b));
  stretch.to = std::min(stretch.to, std::max(a, b));
  return stretch.from <= stretch.to;
}

/** Low plants that follow the ground, in patches. min, max: corners, x y [m]; height: lowest and
 * highest [m]; cover: share of the patches that have any, default 1; cell: side of a patch [m],
 * default 0.5; seed; density, solid: see Leaves. */
class Undergrowth : public Primitive, public Foliage
{
 public:
  Undergrowth(const Tiling& tiling, std::vector<Tile> tiles, const Leaves& leaves)
      : m_tiling(tiling), m_tiles(std::move(tiles)), m_leaves(leaves)
  {
    for (std::size_t i = 0; i < m_tiles.size(); ++i)
      if (m_tiles[i].height > 0) m_grown.push_back(i);
  }

  static Bodies read(params::StrictSection& section, const World& world);

  Footprint footprint() const override { return m_tiling.area(); }

  void appendMesh(Mesh& mesh) const override
  {
    MeshBuilder build(mesh);
    for (const std::size_t i : m_grown)
    {
      const Tile& tile = m_tiles[i];
      const auto corner = [&](double sx, double sy)
      {
        const double x = tile.middle.x + sx * tile.half.x, y = tile.middle.y + sy * tile.half.y;
        return build.vertex(x, y, tile.groundAt(x, y) + tile.height);
      };
      const auto a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1), d = corner(-1, 1);
      build.quad(a, b, c, d);
    }
  }

  const Foliage* foliage() const override { return this; }

  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    if (!m_leaves.solid || !m_tiling.contains(x, y)) return;
    const Tile& tile = tileAt(x, y);
    if (tile.height == 0) return;
    const double ground = tile.groundAt(x, y);
    solids.push_back({ground, ground + tile.height, std::hypot(tile.gradient.x, tile.gradient.y)});
  }

  std::size_t parts() const override { return m_grown.size(); }
  std::array<TPoint3D, 2> boundsOf(std::size_t part) const override
  {
    const Tile& tile = m_tiles[m_grown[part]];
    const TPoint3D reach(tile.half.x, tile.half.y, tile.relief());
    return {tile.middle - reach, tile.middle + reach + TPoint3D(0, 0, tile.height)};
  }
  std::optional<Stretch> inside(std::size_t part, const TPoint3D& origin,
                                const TVector3D& direction) const override
  {
    const Tile& tile = m_tiles[m_grown[part]];
    Stretch stretch{-1e9, 1e9};
    const double climb =
        direction.z - tile.gradient.x * direction.x - tile.gradient.y * direction.y;
    if (clip(origin.x - tile.middle.x + tile.half.x, direction.x, 2 * tile.half.x, stretch) &&
        clip(origin.y - tile.middle.y + tile.half.y, direction.y, 2 * tile.half.y, stretch) &&
        clip(origin.z - tile.groundAt(origin.x, origin.y), climb, tile.height, stretch))
      return stretch;
    return {};
  }
  double density() const override { return m_leaves.density; }

 private:
  const Tile& tileAt(double x, double y) const
  {
    const Footprint& area = m_tiling.area();
    const auto number = [](double metres, double length, std::size_t count)
    { return std::min(static_cast<std::size_t>(metres / length * double(count)), count - 1); };
    return m_tiles[m_tiling.index(number(x - area.xMin, area.xMax - area.xMin, m_tiling.across()),
                                  number(y - area.yMin, area.yMax - area.yMin, m_tiling.along()))];
  }

  Tiling m_tiling;
  std::vector<Tile> m_tiles;         // of all squares
  std::vector<std::size_t> m_grown;  // those that have a height
  Leaves m_leaves;
};

/** The square's ground, without plants. */
Tile bareTile(params::StrictSection& section, const World& world, const Tiling& tiling,
              std::size_t i, std::size_t j)
{
  const auto ground = [&](std::size_t di, std::size_t dj)
  {
    const auto z = world.groundAt(tiling.x(i + di), tiling.y(j + dj));
    if (!z) section.fail("max", "such that there is ground (of a heightField) in all of the area");
    return *z;
  };
  const double z00 = ground(0, 0), z10 = ground(1, 0), z01 = ground(0, 1), z11 = ground(1, 1);
  const double width = tiling.x(i + 1) - tiling.x(i), length = tiling.y(j + 1) - tiling.y(j);
  Tile tile;
  tile.half = {width / 2, length / 2};
  tile.middle = {tiling.x(i) + width / 2, tiling.y(j) + length / 2, (z00 + z10 + z01 + z11) / 4};
  tile.gradient = {(z10 + z11 - z00 - z01) / (2 * width), (z01 + z11 - z00 - z10) / (2 * length)};
  return tile;
}

Bodies Undergrowth::read(params::StrictSection& section, const World& world)
{
  const Outline area = readOutline(section);
  const double cell = readPositive(section, "cell", 0.5);
  if (area.size().x / cell * (area.size().y / cell) > kMostTiles)
    section.fail("cell", "so large that the area has at most 1e6 patches");
  const Interval height = readInterval(section, "height");
  const double cover = section.has("cover") ? readShare(section, "cover") : 1;
  if (cover == 0) section.fail("cover", "above 0");
  std::uint32_t seed = 1;
  section.read("seed", seed);
  const Leaves leaves = Leaves::read(section);

  const Tiling tiling({area.min.x, area.min.y, area.max.x, area.max.y}, cell);
  std::vector<Tile> tiles;
  for (std::size_t j = 0; j < tiling.along(); ++j)
    for (std::size_t i = 0; i < tiling.across(); ++i)
    {
      Random random(randomKey(seed, "undergrowth", tiling.index(i, j)));
      tiles.push_back(bareTile(section, world, tiling, i, j));
      if (random.uniform() < cover) tiles.back().height = height.at(random.uniform());
    }
  const bool anyGrown =
      std::any_of(tiles.begin(), tiles.end(), [](const Tile& tile) { return tile.height > 0; });
  if (!anyGrown) section.fail("cover", "so large that something grows in one of the patches");
  Bodies bodies;
  bodies.push_back(std::make_unique<Undergrowth>(tiling, std::move(tiles), leaves));
  return bodies;
}

const PrimitiveKind kKind("undergrowth", Undergrowth::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
