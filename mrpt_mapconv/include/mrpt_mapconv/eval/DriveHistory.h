#pragma once

#include <mrpt_mapconv/eval/ScanShapeMaps.h>
#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/sim/Sensors.h>
#include <mrpt_mapconv/sim/World.h>

#include <cstdint>
#include <vector>

namespace mrpt_mapconv::eval
{
/** What a cell has been through in a drive. */
struct CellHistory
{
  bool real = false;         //!< a return of the object slice was there where it seemed to be
  bool ghost = false;        //!< one only seemed to be there: it had been reflected
  bool person = false;       //!< a person returned it, in either case
  bool hitByPerson = false;  //!< so did the scan by which it was last updated as occupied
  std::uint16_t freeSincePerson = 0;  //!< in how many scans it was free after the last such one
};

/** Keeps a record of what returned the points of 3D scans, and of the updates by their profiles. */
class DriveHistory
{
 public:
  /** The world must outlive it. */
  DriveHistory(const grid::GridFrame& frame, const sim::World& world,
               const scan::ProfileParams& params);

  /** \param seen what the points of `scan` come from, one by one
   * \param profile of the scan */
  void add(const sim::Scan& seen, const PosedScan& scan, const scan::ScanProfile& profile);
  const grid::Layer<CellHistory>& cells() const { return m_cells; }

 private:
  void addReturns(const sim::Scan& seen, const PosedScan& scan);
  void addUpdates(const scan::ScanProfile& profile);

  scan::ProfileParams m_params;
  std::vector<std::uint8_t> m_isPerson;  //!< of each body of the world: it moves
  grid::Layer<CellHistory> m_cells;
  grid::Layer<std::uint32_t> m_personInScan;  //!< the last with a person's return
  std::uint32_t m_scan = 0;                   //!< the present one's number, from 1
};

}  // namespace mrpt_mapconv::eval
