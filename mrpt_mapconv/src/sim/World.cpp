#include <mrpt_mapconv/sim/World.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "SectionKeys.h"

namespace mrpt_mapconv::sim
{
namespace
{
constexpr double kTouch = 1e-9;  // [m]
constexpr double kCell = 1.0;    // of the coarse grid [m], in worlds that are not larger
constexpr double kMostCellsAcross = 512;

std::size_t cellsAcross(double length, double cellSize)
{
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length / cellSize)));
}

/** Index of the cell on one axis; of the nearest one for a place beyond the bounds. */
std::size_t cellIndex(double place, double begin, double cellSize, std::size_t count)
{
  const double cell = (place - begin) / cellSize;
  return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
}

/** Merges what touches or overlaps; the solids must be sorted by their bottoms. */
void mergeSorted(std::vector<Solid>& solids)
{
  std::size_t last = 0;
  for (std::size_t i = 1; i < solids.size(); ++i)
  {
    if (solids[i].bottom > solids[last].top + kTouch)
      solids[++last] = solids[i];
    else if (solids[i].top > solids[last].top)
    {
      solids[last].top = solids[i].top;
      solids[last].slope = solids[i].slope;
    }
  }
  solids.resize(last + 1);
}

/** Whether a section belongs to somebody else: named exactly, or by a beginning that ends in '.'.
 */
bool isOther(const std::string& section, const std::vector<std::string>& others)
{
  return std::any_of(others.begin(), others.end(),
                     [&](const std::string& other)
                     {
                       if (other.empty() || other.back() != '.') return section == other;
                       return section.compare(0, other.size(), other) == 0;
                     });
}

std::string listed(const std::vector<std::string>& words)
{
  std::string list;
  for (const auto& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

mrpt::math::TPoint3D pointOf(const std::vector<double>& numbers, std::size_t first)
{
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

World emptyWorld(const mrpt::config::CConfigFileBase& ini)
{
  params::StrictSection section(ini, "world");
  const std::string meaning = "six numbers, xMin yMin zMin xMax yMax zMax [m]";
  const auto v = readNumbers(section, "bounds", 6, meaning);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(v[axis] < v[axis + 3])) section.fail("bounds", meaning + ", each max above its min");
  section.refuseUnknown("the world");
  return {pointOf(v, 0), pointOf(v, 3)};
}

/** The kind of a section's body. */
const PrimitiveKind& kindOf(const std::string& name)
{
  const std::size_t dot = name.find('.');
  const std::string kind = name.substr(0, dot);
  const PrimitiveKind* known = PrimitiveKind::find(kind);
  if (!known)
    throw std::runtime_error("section '" + name + "': '" + kind +
                             "' is not a kind of primitive: it must be one of " +
                             listed(PrimitiveKind::names()));
  if (dot == std::string::npos || dot + 1 == name.size())
    throw std::runtime_error("section '" + name + "' has no name of its own: it must be " + kind +
                             ".NAME");
  return *known;
}

Bodies readBodies(const mrpt::config::CConfigFileBase& ini, const std::string& name,
                  const World& world)
{
  const PrimitiveKind& kind = kindOf(name);
  params::StrictSection section(ini, name);
  Bodies bodies;
  if (kind.readStanding)
    bodies = kind.readStanding(section, world);
  else
    bodies.push_back(kind.read(section));
  section.refuseUnknown("a " + name.substr(0, name.find('.')));
  return bodies;
}

void requireBelow(double min, double max, char axis)
{
  if (min < max) return;
  throw std::invalid_argument(std::string("bounds of a world: min ") + axis + " = " +
                              std::to_string(min) + " is not valid: it must be below max " + axis +
                              " = " + std::to_string(max));
}
}  // namespace

World::World(const mrpt::math::TPoint3D& min, const mrpt::math::TPoint3D& max)
    : m_min(min), m_max(max)
{
  requireBelow(m_min.x, m_max.x, 'x');
  requireBelow(m_min.y, m_max.y, 'y');
  requireBelow(m_min.z, m_max.z, 'z');
  const double width = max.x - min.x, height = max.y - min.y;
  m_cellSize = std::max(kCell, std::max(width, height) / kMostCellsAcross);
  m_cellsX = cellsAcross(width, m_cellSize);
  m_cellsY = cellsAcross(height, m_cellSize);
  m_cells.resize(m_cellsX * m_cellsY);
}

World World::fromIni(const mrpt::config::CConfigFileBase& ini,
                     const std::vector<std::string>& otherSections)
{
  World world = emptyWorld(ini);
  std::vector<std::string> sections;
  ini.getAllSections(sections);
  sections.erase(std::remove_if(sections.begin(), sections.end(),
                                [&](const std::string& section)
                                { return section == "world" || isOther(section, otherSections); }),
                 sections.end());
  std::stable_partition(sections.begin(), sections.end(),
                        [](const std::string& name) { return !kindOf(name).readStanding; });
  for (const auto& section : sections)
    for (auto& body : readBodies(ini, section, world)) world.add(section, std::move(body));
  if (world.size() == 0)
    throw std::runtime_error(
        "section 'world': there is no body in it: a section 'KIND.NAME' must be there, KIND one "
        "of " +
        listed(PrimitiveKind::names()));
  return world;
}

void World::add(std::string name, std::unique_ptr<Primitive> primitive)
{
  const auto index = static_cast<std::uint32_t>(m_primitives.size());
  const Footprint area = primitive->footprint();
  for (std::size_t row = rowOf(area.yMin); row <= rowOf(area.yMax); ++row)
    for (std::size_t column = columnOf(area.xMin); column <= columnOf(area.xMax); ++column)
      m_cells[row * m_cellsX + column].push_back(index);
  m_primitives.push_back(std::move(primitive));
  m_names.push_back(std::move(name));
}

std::size_t World::columnOf(double x) const { return cellIndex(x, m_min.x, m_cellSize, m_cellsX); }
std::size_t World::rowOf(double y) const { return cellIndex(y, m_min.y, m_cellSize, m_cellsY); }
std::size_t World::cellAt(double x, double y) const { return rowOf(y) * m_cellsX + columnOf(x); }

void World::solidsAt(double x, double y, std::vector<Solid>& solids) const
{
  solids.clear();
  for (const std::uint32_t i : m_cells[cellAt(x, y)]) m_primitives[i]->appendSolids(x, y, solids);
  if (solids.size() < 2) return;
  std::sort(solids.begin(), solids.end(),
            [](const Solid& a, const Solid& b) { return a.bottom < b.bottom; });
  mergeSorted(solids);
}

std::optional<double> World::groundAt(double x, double y) const
{
  std::vector<Solid> solids;
  for (const std::uint32_t i : m_cells[cellAt(x, y)])
    if (m_primitives[i]->isGround()) m_primitives[i]->appendSolids(x, y, solids);
  const auto highest = std::max_element(
      solids.begin(), solids.end(), [](const Solid& a, const Solid& b) { return a.top < b.top; });
  if (highest == solids.end()) return {};
  return highest->top;
}

bool World::isSolid(const mrpt::math::TPoint3D& point) const
{
  std::vector<Solid> solids;
  solidsAt(point.x, point.y, solids);
  return std::any_of(solids.begin(), solids.end(),
                     [&](const Solid& solid)
                     { return solid.bottom <= point.z && point.z <= solid.top; });
}

bool World::lineHits(double x, double y, double bottom, double top,
                     std::vector<Solid>& scratch) const
{
  solidsAt(x, y, scratch);
  return std::any_of(scratch.begin(), scratch.end(),
                     [&](const Solid& solid)
                     { return solid.bottom < top - kTouch && solid.top > bottom + kTouch; });
}

bool World::sphereHits(const mrpt::math::TPoint3D& centre, double radius, double spacing) const
{
  std::vector<Solid> scratch;
  const auto lineAt = [&](double dx, double dy)
  {
    const double square = radius * radius - dx * dx - dy * dy;
    if (square <= 0) return false;
    const double half = std::sqrt(square);
    return lineHits(centre.x + dx, centre.y + dy, centre.z - half, centre.z + half, scratch);
  };
  const int steps = std::max(1, static_cast<int>(std::ceil(radius / spacing)));
  const double step = radius / steps;
  for (int j = -steps; j <= steps; ++j)
    for (int i = -steps; i <= steps; ++i)
      if (lineAt(i * step, j * step)) return true;

  // the lattice may stay a step away from a wall that only the sphere's side cuts
  constexpr double kTurn = 2 * 3.14159265358979323846;
  const double rim = radius * (1 - 1e-9);
  const int around = std::max(8, static_cast<int>(std::ceil(kTurn * radius / spacing)));
  for (int i = 0; i < around; ++i)
  {
    const double angle = kTurn * i / around;
    if (lineAt(rim * std::cos(angle), rim * std::sin(angle))) return true;
  }
  return false;
}

}  // namespace mrpt_mapconv::sim
