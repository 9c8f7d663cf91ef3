#include "RandomTerrain.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace mrpt_mapconv::test
{
namespace
{
/** What is level lies at multiples of this, more than twice the tolerance [m]. */
constexpr double kLevel = 0.07;
/** A plane holds a square of this side [cells]. */
constexpr int kLeastWidth = 5;
}  // namespace

RandomTerrain::RandomTerrain(Rng& rng)
{
  constexpr int kOrigins[] = {-70, -31, 0, 5, 100000, -100003};
  m_x0 = kOrigins[pick(rng, 0, 5)];
  m_y0 = kOrigins[pick(rng, 0, 5)];
  m_width = pick(rng, 20, 90);
  m_height = pick(rng, 20, 90);
  Piece floor;
  floor.x = m_x0 + 0.5 * m_width;
  floor.y = m_y0 + 0.5 * m_height;
  floor.halfX = 0.5 * m_width;
  floor.halfY = 0.5 * m_height;
  add(floor);
  for (int pieces = pick(rng, 0, 6); pieces > 0; --pieces) switch (pick(rng, 0, 4))
    {
      case 0:
        addStairs(rng);
        break;
      case 1:
        addRamp(rng);
        break;
      case 2:
        addPlate(rng, false);
        break;
      case 3:
        addPlate(rng, true);
        break;
      default:
        cutHole(rng);
    }
  dropNarrowPlanes();
}

terrain::TerrainParams RandomTerrain::params()
{
  terrain::TerrainParams params;
  params.planeTolerance = 0.03;
  return params;
}

RandomTerrain::Piece RandomTerrain::somewhere(Rng& rng, int least, int most) const
{
  Piece piece;
  piece.x = m_x0 + pick(rng, 0, m_width - 1);
  piece.y = m_y0 + pick(rng, 0, m_height - 1);
  piece.halfX = 0.5 * pick(rng, least, most);
  piece.halfY = 0.5 * pick(rng, least, most);
  return piece;
}

/** Horizontal pieces at one height are of one plane; others are of their own. */
int RandomTerrain::labelOf(const Piece& piece)
{
  std::vector<std::int64_t> plane{std::llround(piece.z * 1e6)};
  if (piece.slopeX != 0 || piece.slopeY != 0)
    plane.push_back(static_cast<std::int64_t>(m_labels.size()));
  return m_labels.emplace(plane, static_cast<int>(m_labels.size())).first->second;
}

void RandomTerrain::add(const Piece& piece)
{
  const int label = labelOf(piece);
  const double c = std::cos(piece.angle), s = std::sin(piece.angle);
  for (int y = m_y0; y < m_y0 + m_height; ++y)
    for (int x = m_x0; x < m_x0 + m_width; ++x)
    {
      const double dx = x - piece.x, dy = y - piece.y;
      const double along = c * dx + s * dy, across = c * dy - s * dx;
      if (std::abs(along) > piece.halfX || std::abs(across) > piece.halfY) continue;
      m_cells[{y, x}] = {label, piece.z + piece.slopeX * along + piece.slopeY * across};
    }
}

void RandomTerrain::addStairs(Rng& rng)
{
  Piece tread = somewhere(rng, 10, 30);
  tread.angle = chance(rng, 50) ? pick(rng, 0, 3) * M_PI / 2 : uniform(rng, 0, 2 * M_PI);
  const int depth = pick(rng, 5, 8);
  const double rise = kLevel * pick(rng, 2, 3);
  tread.halfX = 0.5 * depth;
  for (int step = pick(rng, 2, 6); step > 0; --step)
  {
    tread.z += rise;
    tread.x += depth * std::cos(tread.angle);
    tread.y += depth * std::sin(tread.angle);
    add(tread);
  }
}

/** Leaves the floor at its lower edge. */
void RandomTerrain::addRamp(Rng& rng)
{
  Piece ramp = somewhere(rng, 12, 30);
  ramp.slopeX = (chance(rng, 50) ? 1 : -1) * uniform(rng, 0.25, 0.8) * kResolution;
  ramp.angle = pick(rng, 0, 1) * M_PI / 2;
  ramp.z = std::abs(ramp.slopeX) * (ramp.halfX + 1);
  add(ramp);
}

void RandomTerrain::addPlate(Rng& rng, bool tilted)
{
  Piece plate = somewhere(rng, 8, 30);
  plate.z = kLevel * pick(rng, -4, 14);
  if (chance(rng, 50)) plate.angle = uniform(rng, 0, M_PI);
  if (tilted)
  {
    plate.z = 3.0 * ++m_tilted;
    plate.slopeX = uniform(rng, 0.25, 0.6) * kResolution;
    plate.slopeY = uniform(rng, -0.6, 0.6) * kResolution;
  }
  add(plate);
}

void RandomTerrain::cutHole(Rng& rng)
{
  const Piece hole = somewhere(rng, 1, 15);
  for (auto it = m_cells.begin(); it != m_cells.end();)
  {
    const bool isIn = std::abs(it->first.second - hole.x) <= hole.halfX &&
                      std::abs(it->first.first - hole.y) <= hole.halfY;
    it = isIn ? m_cells.erase(it) : std::next(it);
  }
}

void RandomTerrain::dropNarrowPlanes()
{
  const auto parts = oracle::connectedParts(labels());
  std::set<int> wide;
  for (const auto& [key, part] : parts)
  {
    bool isSquare = true;
    for (int i = 0; i < kLeastWidth * kLeastWidth && isSquare; ++i)
    {
      const auto other = parts.find({key.first + i / kLeastWidth, key.second + i % kLeastWidth});
      isSquare = other != parts.end() && other->second == part;
    }
    if (isSquare) wide.insert(part);
  }
  for (const auto& [key, part] : parts)
    if (!wide.count(part)) m_cells.erase(key);
}

oracle::TerrainLabels RandomTerrain::labels() const
{
  oracle::TerrainLabels labels;
  for (const auto& [key, cell] : m_cells) labels[key] = cell.label;
  return labels;
}

TerrainPoints RandomTerrain::points() const
{
  TerrainPoints points;
  for (const auto& [key, cell] : m_cells) points.add(key.second, key.first, cell.z);
  return points;
}

TerrainPoints RandomTerrain::noisyPoints(Rng& rng, double sigma) const
{
  const auto noise = [&]
  {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += uniform(rng, -1, 1);  // of variance 1
    return sigma * sum;
  };
  const Piece rubble = somewhere(rng, 5, 20);
  TerrainPoints points;
  for (const auto& [key, cell] : m_cells)
    for (int i = pick(rng, 1, 3); i > 0; --i)
    {
      const bool isRubble = std::abs(key.second - rubble.x) <= rubble.halfX &&
                            std::abs(key.first - rubble.y) <= rubble.halfY;
      points.add(key.second, key.first, cell.z + noise() + (isRubble ? uniform(rng, 0, 0.3) : 0));
    }
  return points;
}

void TerrainPoints::add(int kx, int ky, double height)
{
  x.push_back(static_cast<float>(kx * RandomTerrain::kResolution));
  y.push_back(static_cast<float>(ky * RandomTerrain::kResolution));
  z.push_back(static_cast<float>(height));
}

terrain::TerrainScan TerrainPoints::scan() const
{
  terrain::TerrainScan scan;
  scan.x = x.data();
  scan.y = y.data();
  scan.z = z.data();
  scan.points = size();
  return scan;
}

void shuffle(Rng& rng, TerrainPoints& points)
{
  for (std::size_t i = points.size(); i > 1; --i)
  {
    const auto j = static_cast<std::size_t>(pick(rng, 0, static_cast<int>(i) - 1));
    std::swap(points.x[i - 1], points.x[j]);
    std::swap(points.y[i - 1], points.y[j]);
    std::swap(points.z[i - 1], points.z[j]);
  }
}

std::vector<TerrainPoints> asScans(Rng& rng, const TerrainPoints& points, int times)
{
  const int count = pick(rng, 1, 8);
  std::vector<TerrainPoints> scans(static_cast<std::size_t>(count));
  const bool arePatches = chance(rng, 70);
  const auto last = static_cast<int>(points.size()) - 1;
  std::vector<int> middles;
  for (int i = 0; i < count; ++i) middles.push_back(pick(rng, 0, last));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto distance = [&](int middle)
    {
      const auto m = static_cast<std::size_t>(middle);
      return std::hypot(points.x[i] - points.x[m], points.y[i] - points.y[m]);
    };
    auto in = std::min_element(middles.begin(), middles.end(),
                               [&](int a, int b) { return distance(a) < distance(b); }) -
              middles.begin();
    if (!arePatches || chance(rng, 10)) in = pick(rng, 0, count - 1);
    for (int left = chance(rng, 20) ? times : 1; left > 0; --left)
    {
      TerrainPoints& scan = scans[static_cast<std::size_t>(in)];
      scan.x.push_back(points.x[i]);
      scan.y.push_back(points.y[i]);
      scan.z.push_back(points.z[i]);
      in = pick(rng, 0, count - 1);
    }
  }
  for (TerrainPoints& scan : scans) shuffle(rng, scan);
  return scans;
}

}  // namespace mrpt_mapconv::test
