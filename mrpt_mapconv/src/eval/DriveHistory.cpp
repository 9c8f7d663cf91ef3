#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/eval/DriveHistory.h>
#include <mrpt_mapconv/grid/CellKey.h>

#include <cmath>
#include <limits>

namespace mrpt_mapconv::eval
{
DriveHistory::DriveHistory(const grid::GridFrame& frame, const sim::World& world,
                           const scan::ProfileParams& params)
    : m_params(params), m_cells(frame, {}), m_personInScan(frame, 0)
{
  for (std::size_t i = 0; i < world.size(); ++i)
    m_isPerson.push_back(world.primitive(i).motion() != nullptr);
}

void DriveHistory::add(const sim::Scan& seen, const PosedScan& scan,
                       const scan::ScanProfile& profile)
{
  ++m_scan;
  addReturns(seen, scan);
  addUpdates(profile);
}

void DriveHistory::addReturns(const sim::Scan& seen, const PosedScan& scan)
{
  const auto& points = scan.points.points;
  const grid::GridFrame& frame = m_cells.frame();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto point = scan.view.sensorPose.composePoint(mrpt::math::TPoint3D(points[i]));
    const double height = point.z - scan.view.baseZ;
    if (height < m_params.objectMinZ || height > m_params.objectMaxZ) continue;
    const double range =
        std::hypot(point.x - scan.view.sensorPose.x(), point.y - scan.view.sensorPose.y());
    if (range < m_params.minRange || range > m_params.maxRange) continue;
    const std::size_t index = frame.indexOfKey(grid::cellKey(point.x, frame.resolution),
                                               grid::cellKey(point.y, frame.resolution));
    CellHistory& cell = m_cells.cells()[index];
    (seen.mirrored[i] ? cell.ghost : cell.real) = true;
    if (!m_isPerson[static_cast<std::size_t>(seen.bodies[i])]) continue;
    cell.person = true;
    m_personInScan.cells()[index] = m_scan;
  }
}

void DriveHistory::addUpdates(const scan::ScanProfile& profile)
{
  const grid::GridFrame bounds = profile.bounds();
  forEachCell(profile.occupied(), bounds, m_cells.frame(),
              [this](std::size_t i)
              {
                CellHistory& cell = m_cells.cells()[i];
                cell.hitByPerson = m_personInScan.cells()[i] == m_scan;
                if (cell.hitByPerson) cell.freeSincePerson = 0;
              });
  forEachCell(profile.free(), bounds, m_cells.frame(),
              [this](std::size_t i)
              {
                CellHistory& cell = m_cells.cells()[i];
                constexpr auto kMost = std::numeric_limits<std::uint16_t>::max();
                if (cell.person && cell.freeSincePerson < kMost) ++cell.freeSincePerson;
              });
}

}  // namespace mrpt_mapconv::eval
