#include <mrpt_mapconv/eval/ScanShapeMaps.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>
#include <stdexcept>

namespace mrpt_mapconv::eval
{
namespace
{
constexpr float kOccupied = 1;

/** The label of one of MRPT's cells, which count what speaks for free. */
float labelOf(std::int8_t cell)
{
  if (cell == 0) return grid::kUnknown;
  return cell > 0 ? grid::kFree : kOccupied;
}
}  // namespace

UpdatedGrid::UpdatedGrid(const grid::GridFrame& frame, const scan::UpdateParams& update)
    : m_update(update), m_cells(frame, 0)
{
}

void UpdatedGrid::add(const scan::ScanProfile& profile)
{
  m_update.apply(profile, m_cells.frame(), m_cells.cells().data());
}

grid::Layer<float> UpdatedGrid::labels() const
{
  grid::Layer<float> labels(m_cells.frame(), grid::kUnknown);
  const auto& cells = m_cells.cells();
  std::transform(cells.begin(), cells.end(), labels.cells().begin(), labelOf);
  return labels;
}

ProfileGrids::ProfileGrids(const grid::GridFrame& frame, const scan::ProfileParams& profile,
                           const std::vector<scan::UpdateParams>& updates)
    : m_params(profile)
{
  for (const scan::UpdateParams& update : updates) m_grids.emplace_back(frame, update);
}

void ProfileGrids::insert(const PosedScan& scan)
{
  m_profile.compute(scan.points.points, scan.view, m_grids.front().frame().resolution, m_params);
  for (UpdatedGrid& grid : m_grids) grid.add(m_profile);
}

void CountGrid::add(const scan::ScanProfile& profile)
{
  const grid::GridFrame bounds = profile.bounds();
  forEachCell(profile.occupied(), bounds, m_occupied.frame(),
              [this](std::size_t cell) { ++m_occupied.cells()[cell]; });
  forEachCell(profile.free(), bounds, m_free.frame(),
              [this](std::size_t cell) { ++m_free.cells()[cell]; });
}

grid::Layer<float> CountGrid::labels() const
{
  grid::Layer<float> labels(m_free.frame(), grid::kUnknown);
  for (std::size_t i = 0; i < labels.cells().size(); ++i)
    if (m_occupied.cells()[i] > 0)
      labels.cells()[i] = kOccupied;
    else if (m_free.cells()[i] > 0)
      labels.cells()[i] = grid::kFree;
  return labels;
}

ScannerGrid::ScannerGrid(const grid::GridFrame& frame,
                         const mrpt::maps::COccupancyGridMap2D::TInsertionOptions& options)
    : m_frame(frame)
{
  m_grid.setSize(static_cast<float>(frame.xMin()), static_cast<float>(frame.xMax()),
                 static_cast<float>(frame.yMin()), static_cast<float>(frame.yMax()),
                 static_cast<float>(frame.resolution));
  m_grid.insertionOptions = options;
}

bool ScannerGrid::insert(const mrpt::obs::CObservation& scan, const mrpt::poses::CPose3D& robotPose)
{
  return m_grid.insertObservation(scan, robotPose);
}

grid::Layer<float> ScannerGrid::labels() const
{
  const auto& cells = m_grid.getRawMap();
  grid::Layer<float> labels(m_frame, grid::kUnknown);
  if (cells.size() != labels.cells().size())
    throw std::runtime_error(
        "the 2D scans reach beyond the world's bounds by more than maxDistanceInsertion");
  std::transform(cells.begin(), cells.end(), labels.cells().begin(), labelOf);
  return labels;
}

}  // namespace mrpt_mapconv::eval
