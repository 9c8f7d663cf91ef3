#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/GrownFrame.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

// Where the grid of a CScanShapeGridMap2D lies, how it grows, and what its cells say.

namespace mrpt_mapconv
{
namespace
{
constexpr std::int32_t kStartSide = 20;  // cells; MRPT's grids are never without

double cellsOf(const grid::GridFrame& frame)
{
  return static_cast<double>(frame.width) * static_cast<double>(frame.height);
}

bool fitsMrpt(const grid::GridFrame& frame)
{
  try
  {
    grid::checkGridMapFrame(frame);
    return true;
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
}

}  // namespace

grid::GridFrame CScanShapeGridMap2D::frame() const
{
  const bool own = m_resolution == static_cast<float>(m_cellSize);
  const auto key = [this](float metres)
  {
    return static_cast<std::int32_t>(
        std::lround(static_cast<double>(metres) / static_cast<double>(m_resolution)));
  };
  return {own ? m_cellSize : static_cast<double>(m_resolution), key(m_xMin), key(m_yMin),
          static_cast<std::int32_t>(m_size_x), static_cast<std::int32_t>(m_size_y)};
}

void CScanShapeGridMap2D::startEmpty()
{
  const auto resolution = static_cast<float>(m_cellSize);
  const float half = resolution * 0.5f * static_cast<float>(kStartSide);
  setSize(-half, half, -half, half, resolution);
}

/** True if nobody has put anything into the grid that a new map begins with. */
bool CScanShapeGridMap2D::isAsStarted() const
{
  return m_is_empty &&
         frame() == grid::GridFrame{m_cellSize, -kStartSide / 2, -kStartSide / 2, kStartSide,
                                    kStartSide} &&
         std::all_of(m_map.begin(), m_map.end(), [](cellType cell) { return cell == 0; });
}

/** Lets the grid hold these cells.
 * \exception std::runtime_error if it would be too large; it then stays as it was */
void CScanShapeGridMap2D::makeRoomFor(const grid::GridFrame& needed)
{
  const grid::GridFrame now = frame();
  // where a map begins says nothing about where it lies
  const grid::GridFrame least = isAsStarted() ? needed : unite(now, needed);
  if (least == now) return;
  checkSize(least);
  constexpr grid::GrowthMargin margin{0.25, 10, 1};  // a drive must not copy it at each scan
  layOut(grid::grownFrame(isAsStarted() ? grid::GridFrame() : now, needed, margin,
                          [this](const grid::GridFrame& roomy)
                          { return cellsOf(roomy) <= maxGridCells && fitsMrpt(roomy); }));
}

/** \exception std::runtime_error for a finite pose whose cells keys cannot count; the grid of any
 * less distant one is checked itself */
void CScanShapeGridMap2D::checkNear(const mrpt::poses::CPose3D& sensorPose) const
{
  constexpr double farthest = 1e9;  // cells, so that keys stay within 32 bits
  if (std::max(std::abs(sensorPose.x()), std::abs(sensorPose.y())) <= farthest * frame().resolution)
    return;
  std::ostringstream message;
  message << "the scan's pose (" << sensorPose.x() << ", " << sensorPose.y() << ") is more than "
          << farthest << " cells from the origin; is it right?";
  throw std::runtime_error(message.str());
}

void CScanShapeGridMap2D::checkSize(const grid::GridFrame& least) const
{
  constexpr double mrptsMost = std::numeric_limits<std::uint32_t>::max();
  if (!(cellsOf(least) <= std::min(maxGridCells, mrptsMost)))
  {
    std::ostringstream message;
    message << "maxGridCells = " << maxGridCells << ": with this scan the grid would have "
            << least.width << " x " << least.height << " = " << cellsOf(least)
            << " cells; is the scan's pose right?";
    throw std::runtime_error(message.str());
  }
  grid::checkGridMapFrame(least);
}

/** Lays the grid out anew. The frame has to hold all cells that say something. */
void CScanShapeGridMap2D::layOut(const grid::GridFrame& target)
{
  std::vector<cellType> cells(target.size(), 0);
  if (!isAsStarted())
  {
    const grid::GridFrame now = frame();
    for (std::int32_t iy = 0; iy < now.height; ++iy)
      std::copy_n(getRow(iy), now.width, &cells[target.indexOfKey(now.x0, now.y0 + iy)]);
  }
  m_map.swap(cells);
  m_size_x = static_cast<std::uint32_t>(target.width);
  m_size_y = static_cast<std::uint32_t>(target.height);
  // as setSize() rounds them, so that the same 2D scan gives the same cells as in MRPT's own grid
  m_xMin = m_resolution * static_cast<float>(target.x0);
  m_xMax = m_resolution * static_cast<float>(target.xEnd());
  m_yMin = m_resolution * static_cast<float>(target.y0);
  m_yMax = m_resolution * static_cast<float>(target.yEnd());
  m_basis_map.clear();
  m_voronoi_diagram.clear();
  m_likelihoodCacheOutDated = true;
}

grid::Layer<float> CScanShapeGridMap2D::probability() const
{
  grid::Layer<float> layer(frame(), 0);
  std::transform(m_map.begin(), m_map.end(), layer.cells().begin(),
                 [](cellType cell)
                 { return cell == 0 ? std::numeric_limits<float>::quiet_NaN() : 1 - l2p(cell); });
  return layer;
}

grid::Layer<float> CScanShapeGridMap2D::occupancy() const
{
  grid::Layer<float> layer(frame(), grid::kUnknown);
  std::transform(m_map.begin(), m_map.end(), layer.cells().begin(),
                 [](cellType cell)
                 {
                   if (cell == 0) return grid::kUnknown;
                   return cell > 0 ? grid::kFree : 1 - l2p(cell);
                 });
  return layer;
}

}  // namespace mrpt_mapconv
