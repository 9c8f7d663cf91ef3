#include "TruePlanes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace mrpt_mapconv::eval
{
using grid::GridFrame;
using grid::Layer;
using terrain::TerrainPlane;

namespace
{
constexpr double kSame = 1e-6;  // heights [m] and slopes [m/m] that differ by no more are the same

/** Finds one plane after the other. */
class PlaneFinder
{
 public:
  PlaneFinder(const Layer<SurfacePoint>& surface, Layer<std::int32_t>& plane)
      : m_surface(surface), m_frame(surface.frame()), m_plane(plane)
  {
  }

  /** The plane of a cell at column ix, row iy, which is in none yet; none: nothing tells how it is
   * tilted. */
  std::optional<TerrainPlane> planeAt(std::int32_t ix, std::int32_t iy) const
  {
    for (const std::int32_t dx : {1, -1})
      for (const std::int32_t dy : {1, -1})
      {
        const auto slopeX = slopeTo(ix, iy, dx, 0), slopeY = slopeTo(ix, iy, 0, dy);
        if (!slopeX || !slopeY) continue;
        if (std::abs(std::hypot(*slopeX, *slopeY) - at(ix, iy).slope) > kSame) continue;
        TerrainPlane found;
        found.slopeX = *slopeX;
        found.slopeY = *slopeY;
        found.x = m_frame.centreOf(m_frame.x0 + ix);
        found.y = m_frame.centreOf(m_frame.y0 + iy);
        found.z = at(ix, iy).height;
        return found;
      }
    return std::nullopt;
  }

  /** Gives all connected cells of a plane its number, from a cell that is in it.
   * \return the plane, which knows its cells */
  TerrainPlane fill(const TerrainPlane& tilted, std::int32_t number, std::int32_t ix,
                    std::int32_t iy)
  {
    TerrainPlane grown = tilted;
    std::int32_t left = ix, right = ix, low = iy, high = iy;
    double sumX = 0, sumY = 0;
    m_open.assign(1, {ix, iy});
    m_plane.at(ix, iy) = number;
    while (!m_open.empty())
    {
      const auto [x, y] = m_open.back();
      m_open.pop_back();
      ++grown.cells;
      sumX += x;
      sumY += y;
      left = std::min(left, x), right = std::max(right, x);
      low = std::min(low, y), high = std::max(high, y);
      for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}})
        take(tilted, at(ix, iy).slope, number, x + dx, y + dy);
    }
    const auto cells = static_cast<double>(grown.cells);
    grown.x = m_frame.centreOf(m_frame.x0) + sumX / cells * m_frame.resolution;
    grown.y = m_frame.centreOf(m_frame.y0) + sumY / cells * m_frame.resolution;
    grown.z = tilted.heightAt(grown.x, grown.y);
    grown.xMin = m_frame.edgeOf(m_frame.x0 + left);
    grown.yMin = m_frame.edgeOf(m_frame.y0 + low);
    grown.xMax = m_frame.edgeOf(m_frame.x0 + right + 1);
    grown.yMax = m_frame.edgeOf(m_frame.y0 + high + 1);
    grown.firstX = m_frame.x0 + ix;
    grown.firstY = m_frame.y0 + iy;
    return grown;
  }

 private:
  const SurfacePoint& at(std::int32_t ix, std::int32_t iy) const { return m_surface.at(ix, iy); }
  bool isFree(std::int32_t ix, std::int32_t iy) const
  {
    return ix >= 0 && iy >= 0 && ix < m_frame.width && iy < m_frame.height &&
           std::isfinite(at(ix, iy).height) && m_plane.at(ix, iy) < 0;
  }

  /** Slope towards x or y, between a cell and one beside it that has the same slope. */
  std::optional<double> slopeTo(std::int32_t ix, std::int32_t iy, std::int32_t dx,
                                std::int32_t dy) const
  {
    if (!isFree(ix + dx, iy + dy)) return std::nullopt;
    const SurfacePoint &here = at(ix, iy), &there = at(ix + dx, iy + dy);
    if (std::abs(here.slope - there.slope) > kSame) return std::nullopt;
    return (there.height - here.height) * (dx + dy) / m_frame.resolution;
  }

  void take(const TerrainPlane& tilted, double slope, std::int32_t number, std::int32_t ix,
            std::int32_t iy)
  {
    if (!isFree(ix, iy)) return;
    const double height =
        tilted.heightAt(m_frame.centreOf(m_frame.x0 + ix), m_frame.centreOf(m_frame.y0 + iy));
    if (std::abs(at(ix, iy).height - height) > kSame) return;
    if (std::abs(at(ix, iy).slope - slope) > kSame) return;
    m_plane.at(ix, iy) = number;
    m_open.push_back({ix, iy});
  }

  const Layer<SurfacePoint>& m_surface;
  const GridFrame& m_frame;
  Layer<std::int32_t>& m_plane;
  std::vector<std::pair<std::int32_t, std::int32_t>> m_open;
};
}  // namespace

std::vector<TerrainPlane> truePlanes(const Layer<SurfacePoint>& surface, Layer<std::int32_t>& plane)
{
  std::vector<TerrainPlane> planes;
  PlaneFinder finder(surface, plane);
  for (std::int32_t iy = 0; iy < surface.frame().height; ++iy)
    for (std::int32_t ix = 0; ix < surface.frame().width; ++ix)
    {
      if (plane.at(ix, iy) >= 0 || !std::isfinite(surface.at(ix, iy).height)) continue;
      if (const auto tilted = finder.planeAt(ix, iy))
        planes.push_back(finder.fill(*tilted, static_cast<std::int32_t>(planes.size()), ix, iy));
    }
  return planes;
}

}  // namespace mrpt_mapconv::eval
