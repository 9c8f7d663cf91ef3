#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "TerrainMapImpl.h"

namespace mrpt_mapconv::terrain
{
using mrpt::serialization::CArchive;

namespace
{
constexpr std::uint8_t kVersion = 0;
constexpr std::uint32_t kMostTiles = 1u << 26, kMostPlanes = 1u << 30;
constexpr std::int64_t kMostTileKey = std::int64_t{1} << 25;  // 2^30 cells

[[noreturn]] void refuse(const std::string& why)
{
  throw std::runtime_error("terrain map stream: " + why);
}

std::uint32_t readCount(CArchive& in, std::uint32_t most, const char* what)
{
  std::uint32_t count = 0;
  in >> count;
  if (count > most) refuse(std::string("holds ") + std::to_string(count) + " " + what);
  return count;
}

template <class Archive, class P>
void pass(Archive&& each, P& plane)
{
  each(plane.originX);
  each(plane.originY);
  each(plane.height);
  each(plane.slopeX);
  each(plane.slopeY);
}

/** All of a plane but its moments, which are those of its cells about an origin. */
template <class Each, class S>
void passState(const Each& each, S& state)
{
  pass(each, state.plane);
  pass(each, state.settled);
  each(state.tiles.xMin);
  each(state.tiles.yMin);
  each(state.tiles.xMax);
  each(state.tiles.yMax);
  each(state.isAlive);
  each(state.hasChanged);
  each(state.hasLost);
}

template <class Each, class S>
void passSums(const Each& each, S& sums)
{
  each(sums.weightedHeight);
  each(sums.weight);
  each(sums.highest);
  each(sums.points);
}

void writePlanes(CArchive& out, const PlaneSet& planes)
{
  out << static_cast<std::uint32_t>(planes.end());
  for (std::int32_t id = 0; id < planes.end(); ++id)
  {
    const PlaneMoments& moments = planes.at(id).moments;
    out << moments.originX() << moments.originY() << moments.originZ();
    passState([&out](const auto& value) { out << value; }, planes.at(id));
  }
  out << planes.freeNumbers();
}

PlaneSet readPlanes(CArchive& in)
{
  const std::uint32_t planeCount = readCount(in, kMostPlanes, "planes");
  std::vector<PlaneState> states;  // grows as they come: a damaged number must not ask for memory
  for (std::uint32_t i = 0; i < planeCount; ++i)
  {
    PlaneState& state = states.emplace_back();
    std::int32_t x = 0, y = 0, z = 0;
    in >> x >> y >> z;
    state.moments = PlaneMoments(x, y, z);
    passState([&in](auto& value) { in >> value; }, state);
  }
  std::vector<std::int32_t> freeNumbers;
  in >> freeNumbers;
  std::vector<bool> isFree(states.size(), false);
  for (const std::int32_t id : freeNumbers)
  {
    if (id < 0 || static_cast<std::size_t>(id) >= states.size() ||
        states[static_cast<std::size_t>(id)].isAlive || isFree[static_cast<std::size_t>(id)])
      refuse("plane " + std::to_string(id) + " is not free");
    isFree[static_cast<std::size_t>(id)] = true;
  }
  PlaneSet planes;
  planes.restore(std::move(states), std::move(freeNumbers));
  return planes;
}

void writeTile(CArchive& out, const Tile& tile)
{
  out << tile.tx << tile.ty;
  for (std::size_t y = 0; y < kTileSide; ++y) out << tile.known[y] << tile.changed[y];
  for (std::int32_t iy = 0; iy < kTileSide; ++iy)
  {
    const auto y = static_cast<std::size_t>(iy);
    forEachBit(tile.known[y] | tile.changed[y],
               [&](std::int32_t ix)
               {
                 const std::size_t index = Tile::indexOf(ix, iy);
                 passSums([&out](const auto& value) { out << value; }, tile.sums[index]);
                 out << static_cast<std::uint32_t>(tile.sums[index].triedWith);
                 out << tile.height[index] << tile.plane[index];
               });
  }
}

void readCell(CArchive& in, Tile& tile, std::int32_t ix, std::int32_t iy, PlaneSet& planes)
{
  const std::size_t index = Tile::indexOf(ix, iy);
  std::int32_t plane = kNoPlane;
  std::uint32_t triedWith = 0;
  passSums([&in](auto& value) { in >> value; }, tile.sums[index]);
  in >> triedWith >> tile.height[index] >> plane;
  tile.sums[index].triedWith = triedWith & 0x7FFFFFFFu;
  tile.sums[index].isMarked = tile.changed[static_cast<std::size_t>(iy)] >> ix & 1u;
  const CellSums& sums = tile.sums[index];
  if (sums.points == 0 || sums.weight == 0 || sums.weight >> 61 != 0 || sums.highestWeight() == 0)
    refuse("holds a cell without points");
  if (plane == kNoPlane) return;
  if (plane < 0 || plane >= planes.end() || !planes.at(plane).isAlive || !tile.isKnown(ix, iy))
    refuse("a cell belongs to plane " + std::to_string(plane) + ", which is not there");
  planes.at(plane).moments.add(tile.keyX(ix), tile.keyY(iy), tile.height[index]);
  tile.assign(index, plane);
}
}  // namespace

void TerrainMap::save(CArchive& out) const
{
  out << kVersion << m_impl->resolution << m_impl->allOpen;
  out << m_impl->window.has_value();
  const KeyWindow window = m_impl->window.value_or(KeyWindow{});
  out << window.xMin << window.yMin << window.xMax << window.yMax;
  writePlanes(out, m_impl->planes);
  out << static_cast<std::uint32_t>(m_impl->tiles.size());
  for (const Tile* tile : m_impl->tiles.sorted()) writeTile(out, *tile);
}

void TerrainMap::load(CArchive& in)
{
  std::uint8_t version = 0;
  double resolution = 0;
  in >> version >> resolution;
  if (version > kVersion) refuse("unknown version " + std::to_string(version));
  auto read = std::make_unique<Impl>(resolution, params());
  bool hasWindow = false;
  KeyWindow window;
  in >> read->allOpen >> hasWindow >> window.xMin >> window.yMin >> window.xMax >> window.yMax;
  if (hasWindow) read->window = window;
  read->planes = readPlanes(in);
  const std::uint32_t tiles = readCount(in, kMostTiles, "tiles");
  for (std::uint32_t i = 0; i < tiles; ++i)
  {
    std::int32_t tx = 0, ty = 0;
    in >> tx >> ty;
    if (std::max(std::abs(std::int64_t{tx}), std::abs(std::int64_t{ty})) > kMostTileKey)
      refuse("holds a tile beyond the range of keys");
    if (read->tiles.find(tx, ty)) refuse("holds a tile twice");
    Tile& tile = read->tiles.get(tx, ty);
    for (std::size_t y = 0; y < kTileSide; ++y) in >> tile.known[y] >> tile.changed[y];
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
    {
      const auto y = static_cast<std::size_t>(iy);
      read->cells += static_cast<std::size_t>(countOf(tile.known[y] | tile.changed[y]));
      tile.hasChanged |= tile.changed[y] != 0;
      forEachBit(tile.known[y] | tile.changed[y],
                 [&](std::int32_t ix) { readCell(in, tile, ix, iy, read->planes); });
    }
  }
  read->tree.follow(read->tiles, 0);
  read->listPlanes();
  m_impl = std::move(read);
}

}  // namespace mrpt_mapconv::terrain
