#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <cstdint>
#include <vector>

namespace mrpt_mapconv::eval
{
/** A 3D scan as the maps get it. */
struct PosedScan
{
  observation::SensorPoints points;
  scan::Viewpoint view;
};

/** Calls visit(index of the cell in `frame`) for the cells of one of a profile's sets. The frame
 * must hold them. */
template <class Visit>
void forEachCell(const scan::CellBits& cells, const grid::GridFrame& bounds,
                 const grid::GridFrame& frame, const Visit& visit)
{
  for (std::int32_t ky = bounds.y0; ky < bounds.yEnd(); ++ky)
    for (std::int32_t kx = bounds.x0; kx < bounds.xEnd(); ++kx)
      if (cells.containsKey(kx, ky)) visit(frame.indexOfKey(kx, ky));
}

/** A grid of MRPT's cells that profiles of scans update. */
class UpdatedGrid
{
 public:
  UpdatedGrid(const grid::GridFrame& frame, const scan::UpdateParams& update);

  void add(const scan::ScanProfile& profile);
  /** 0 where p < 0.5, 1 where p > 0.5, else −1. */
  grid::Layer<float> labels() const;
  const grid::GridFrame& frame() const { return m_cells.frame(); }

 private:
  scan::LogOddsUpdate m_update;
  grid::Layer<std::int8_t> m_cells;
};

/** Grids that are updated with the same profile of each scan, by different increments. */
class ProfileGrids
{
 public:
  ProfileGrids(const grid::GridFrame& frame, const scan::ProfileParams& profile,
               const std::vector<scan::UpdateParams>& updates);

  void insert(const PosedScan& scan);
  /** Of the last scan. */
  const scan::ScanProfile& profile() const { return m_profile; }
  /** \param i the number of the increments */
  grid::Layer<float> labels(std::size_t i = 0) const { return m_grids[i].labels(); }

 private:
  scan::ProfileParams m_params;
  scan::ScanProfile m_profile;
  std::vector<UpdatedGrid> m_grids;
};

/** How often each cell was seen occupied and free, and a map that forgets nothing of that. */
class CountGrid
{
 public:
  explicit CountGrid(const grid::GridFrame& frame) : m_occupied(frame, 0), m_free(frame, 0) {}

  void add(const scan::ScanProfile& profile);
  /** 1 where it ever was occupied, else 0 where it ever was free, else −1. */
  grid::Layer<float> labels() const;

 private:
  grid::Layer<std::uint32_t> m_occupied, m_free;
};

/** MRPT's own grid of 2D scans, which is not to grow beyond its frame. */
class ScannerGrid
{
 public:
  ScannerGrid(const grid::GridFrame& frame,
              const mrpt::maps::COccupancyGridMap2D::TInsertionOptions& options);

  /** \return false if MRPT refuses it */
  bool insert(const mrpt::obs::CObservation& scan, const mrpt::poses::CPose3D& robotPose);
  /** As those of UpdatedGrid. \exception std::runtime_error if the grid has grown */
  grid::Layer<float> labels() const;

 private:
  grid::GridFrame m_frame;
  mrpt::maps::COccupancyGridMap2D m_grid;
};

}  // namespace mrpt_mapconv::eval
