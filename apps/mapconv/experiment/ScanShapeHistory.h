#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/sim/Sensors.h>
#include <mrpt_mapconv/sim/World.h>

#include <cstdint>
#include <vector>

#include "ScanShapeMaps.h"

namespace mapconv
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
  DriveHistory(const mrpt_mapconv::grid::GridFrame& frame, const mrpt_mapconv::sim::World& world,
               const mrpt_mapconv::scan::ProfileParams& params);

  /** \param seen what the points of `scan` come from, one by one
   * \param profile of the scan */
  void add(const mrpt_mapconv::sim::Scan& seen, const PosedScan& scan,
           const mrpt_mapconv::scan::ScanProfile& profile);
  const mrpt_mapconv::grid::Layer<CellHistory>& cells() const { return m_cells; }

 private:
  void addReturns(const mrpt_mapconv::sim::Scan& seen, const PosedScan& scan);
  void addUpdates(const mrpt_mapconv::scan::ScanProfile& profile);

  mrpt_mapconv::scan::ProfileParams m_params;
  std::vector<std::uint8_t> m_isPerson;  //!< of each body of the world: it moves
  mrpt_mapconv::grid::Layer<CellHistory> m_cells;
  mrpt_mapconv::grid::Layer<std::uint32_t> m_personInScan;  //!< the last with a person's return
  std::uint32_t m_scan = 0;                                 //!< the present one's number, from 1
};

}  // namespace mapconv
