#include <algorithm>
#include <cmath>

#include "../MeshBuilder.h"
#include "../Relief.h"
#include "../SectionKeys.h"
#include "../Terraces.h"
#include "../Tiling.h"
#include "../Tunnels.h"

namespace mrpt_mapconv::sim
{
namespace
{
constexpr double kMostPoints = 2e7;

/** A surface over a rectangular lattice, each of whose squares is two triangles. */
class Lattice
{
 public:
  /** The triangle's plane over a place. */
  struct Surface
  {
    double height, slope;
  };

  /** \param spacing of the points at most [m] */
  Lattice(const Footprint& area, double spacing)
      : m_squares(area, spacing),
        m_perMetreX(double(m_squares.across()) / (area.xMax - area.xMin)),
        m_perMetreY(double(m_squares.along()) / (area.yMax - area.yMin)),
        m_heights((m_squares.across() + 1) * (m_squares.along() + 1))
  {
  }

  const Tiling& squares() const { return m_squares; }
  float& height(std::size_t i, std::size_t j)
  {
    return m_heights[j * (m_squares.across() + 1) + i];
  }
  float height(std::size_t i, std::size_t j) const
  {
    return m_heights[j * (m_squares.across() + 1) + i];
  }
  const std::vector<float>& heights() const { return m_heights; }

  /** For a place inside. */
  Surface at(double px, double py) const
  {
    const double u = (px - m_squares.area().xMin) * m_perMetreX,
                 v = (py - m_squares.area().yMin) * m_perMetreY;
    const std::size_t i = std::min(static_cast<std::size_t>(u), m_squares.across() - 1);
    const std::size_t j = std::min(static_cast<std::size_t>(v), m_squares.along() - 1);
    const double s = u - double(i), t = v - double(j);
    const double h00 = height(i, j), h11 = height(i + 1, j + 1);
    // the square is cut from its corner (0, 0) to (1, 1), as the mesh is
    const double corner = s > t ? height(i + 1, j) : height(i, j + 1);
    const double alongX = s > t ? corner - h00 : h11 - corner;
    const double alongY = s > t ? h11 - corner : corner - h00;
    const double slopeX = alongX * m_perMetreX, slopeY = alongY * m_perMetreY;
    return {h00 + s * alongX + t * alongY, std::sqrt(slopeX * slopeX + slopeY * slopeY)};
  }

 private:
  Tiling m_squares;
  double m_perMetreX, m_perMetreY;  // squares to a metre
  std::vector<float> m_heights;
};

/** Adds a lattice's surface, and a flat face below or above it with sides to it, to a mesh. */
class Faces
{
 public:
  Faces(const Lattice& lattice, Mesh& mesh) : m_lattice(lattice), m_build(mesh)
  {
    m_first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::size_t j = 0; j <= lattice.squares().along(); ++j)
      for (std::size_t i = 0; i <= lattice.squares().across(); ++i)
        m_build.vertex(lattice.squares().x(i), lattice.squares().y(j), lattice.height(i, j));
  }

  void surface()
  {
    for (std::size_t j = 0; j < m_lattice.squares().along(); ++j)
      for (std::size_t i = 0; i < m_lattice.squares().across(); ++i)
        m_build.quad(point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
  }

  void sides(double flat)
  {
    const std::size_t right = m_lattice.squares().across(), upper = m_lattice.squares().along();
    for (const std::size_t j : {std::size_t{0}, upper})
      for (std::size_t i = 0; i < right; ++i) side(i, j, i + 1, j, flat);
    for (const std::size_t i : {std::size_t{0}, right})
      for (std::size_t j = 0; j < upper; ++j) side(i, j, i, j + 1, flat);
  }

  void flatFace(double flat)
  {
    const Footprint& area = m_lattice.squares().area();
    m_build.quad(
        m_build.vertex(area.xMin, area.yMin, flat), m_build.vertex(area.xMax, area.yMin, flat),
        m_build.vertex(area.xMax, area.yMax, flat), m_build.vertex(area.xMin, area.yMax, flat));
  }

 private:
  std::uint32_t point(std::size_t i, std::size_t j) const
  {
    return m_first + static_cast<std::uint32_t>(j * (m_lattice.squares().across() + 1) + i);
  }
  void side(std::size_t i0, std::size_t j0, std::size_t i1, std::size_t j1, double flat)
  {
    m_build.quad(point(i0, j0), point(i1, j1),
                 m_build.vertex(m_lattice.squares().x(i1), m_lattice.squares().y(j1), flat),
                 m_build.vertex(m_lattice.squares().x(i0), m_lattice.squares().y(j0), flat));
  }

  const Lattice& m_lattice;
  MeshBuilder m_build;
  std::uint32_t m_first;
};

/** Ground or a rock ceiling with a smooth, uneven surface (see Relief, Terraces and Tunnels for
 * their keys). min, max: corners x y [m]; cell: spacing of the surface's points [m]; solid: below
 * or above it; depth: thickness beyond the surface's lowest or highest point [m], default 1; for
 * tunnels, which only rock above can have, wallBottom: height that the rock reaches down to beside
 * them [m]. */
class HeightField : public Primitive
{
 public:
  HeightField(Lattice lattice, bool solidAbove, double depth)
      : m_lattice(std::move(lattice)), m_solidAbove(solidAbove)
  {
    const auto& heights = m_lattice.heights();
    m_flat = solidAbove ? *std::max_element(heights.begin(), heights.end()) + depth
                        : *std::min_element(heights.begin(), heights.end()) - depth;
  }

  static std::unique_ptr<Primitive> read(params::StrictSection& section)
  {
    Lattice lattice = readLattice(section);
    require(section, "solid", "below or above");
    int solid = 0;
    section.readChoice("solid", {"below", "above"}, solid);
    const double depth = section.has("depth") ? readPositive(section, "depth") : 1.0;
    const Relief relief = Relief::read(section);
    const Terraces terraces = Terraces::read(section, relief.seed);
    const Tunnels tunnels = Tunnels::read(section);
    if (!tunnels.empty() && solid == 0) section.fail("solid", "above for tunnels (arch_1 ...)");
    const double wallBottom = tunnels.empty() ? 0 : readNumber(section, "wallBottom");

    for (std::size_t j = 0; j <= lattice.squares().along(); ++j)
      for (std::size_t i = 0; i <= lattice.squares().across(); ++i)
      {
        double height =
            terraces.heightAt(relief.heightAt(lattice.squares().x(i), lattice.squares().y(j)));
        if (!tunnels.empty())
        {
          const double vault = tunnels.vaultAt({lattice.squares().x(i), lattice.squares().y(j)});
          height = vault > 0 ? height + vault : wallBottom;
        }
        lattice.height(i, j) = static_cast<float>(height);
      }
    return std::make_unique<HeightField>(std::move(lattice), solid == 1, depth);
  }

  Footprint footprint() const override { return m_lattice.squares().area(); }

  bool isGround() const override { return !m_solidAbove; }

  void appendMesh(Mesh& mesh) const override
  {
    Faces faces(m_lattice, mesh);
    faces.surface();
    faces.sides(m_flat);
    faces.flatFace(m_flat);
  }

  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    if (!m_lattice.squares().contains(x, y)) return;
    const auto [height, slope] = m_lattice.at(x, y);
    if (m_solidAbove)
      solids.push_back({height, m_flat, 0});
    else
      solids.push_back({m_flat, height, slope});
  }

 private:
  static Lattice readLattice(params::StrictSection& section)
  {
    const auto [min, max] = readOutline(section);
    const double cell = readPositive(section, "cell");
    if ((max.x - min.x) / cell * ((max.y - min.y) / cell) > kMostPoints)
      section.fail("cell", "so large that the field has at most 2e7 points");
    return {{min.x, min.y, max.x, max.y}, cell};
  }

  Lattice m_lattice;
  bool m_solidAbove;
  double m_flat;
};

const PrimitiveKind kKind("heightField", HeightField::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
