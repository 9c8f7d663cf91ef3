#pragma once

#include <mrpt_mapconv/sim/Primitive.h>

#include <array>
#include <vector>

namespace mrpt_mapconv::sim
{
/** Adds faces to a mesh. */
class MeshBuilder
{
 public:
  using Point2 = std::array<double, 2>;

  explicit MeshBuilder(Mesh& mesh) : m_mesh(mesh) {}

  std::uint32_t vertex(double x, double y, double z)
  {
    m_mesh.vertices.push_back(
        {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
    return static_cast<std::uint32_t>(m_mesh.vertices.size() - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    m_mesh.triangles.push_back({a, b, c});
  }
  /** A flat face with four corners, in their order around it. */
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
  {
    triangle(a, b, c);
    triangle(a, c, d);
  }
  /** An upright body over a convex outline, with its bottom and top. */
  void prism(const std::vector<Point2>& outline, double bottom, double top)
  {
    std::vector<std::uint32_t> low, high;
    for (const auto& [x, y] : outline)
    {
      low.push_back(vertex(x, y, bottom));
      high.push_back(vertex(x, y, top));
    }
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      const std::size_t next = (i + 1) % outline.size();
      quad(low[i], low[next], high[next], high[i]);
      if (i < 2) continue;
      triangle(low[0], low[i], low[i - 1]);
      triangle(high[0], high[i - 1], high[i]);
    }
  }

 private:
  Mesh& m_mesh;
};

}  // namespace mrpt_mapconv::sim
