#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/params/StrictSection.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>
#include <mrpt_mapconv/scan/ProfileParams.h>

#include <optional>
#include <string>
#include <vector>

namespace mrpt_mapconv::scan
{
/** How options call the models, in the order of the enumeration. */
const std::vector<std::string>& modelNames();
const std::string& nameOf(scan::Model model);

/** How 3D scans are inserted into a CScanShapeGridMap2D.
 *
 * In an ini file: `model = wholeShape | closestPoint`, `robotHeight` (1.5 m), `objectMinZ`,
 * `objectMaxZ` (another name for robotHeight), `reflectionFilter`, `structureMinZ`, `structureMaxZ`
 * (needed with the filter), `minRange`, `maxRange`, `sectors`, `structureGap` [degrees; −1:
 * default], `structureTolerance`, `pHit`, `pMiss`, `pMin`, `pMax`, `insert2D`; see
 * scan::ProfileParams and scan::UpdateParams. */
struct TScanInsertionOptions : public mrpt::config::CLoadableOptions
{
  scan::ProfileParams profile;
  scan::UpdateParams update;
  bool insert2D = true;  //!< insert 2D range scans, too, as MRPT's own grid does

  /** \exception std::invalid_argument naming the option, its value and what would be right */
  void check() const;
  /** The same, and that scans of this maxRange fit into cells of a size.
   * \param resolution size of the map's cells [m]
   * \exception std::invalid_argument likewise, e.g. "maxRange = 20 is not valid: with resolution =
   * 0.001 m it must be at most 10 m (10000 cells)" */
  void check(double resolution) const;

  /** Reads the keys that are there; warns about others.
   * \exception std::runtime_error naming section, key and value; the options then stay as they were
   */
  void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                          const std::string& section) override;
  /** The same from a section that may hold keys of others: does not warn.
   * \param resolution size of the map's cells [m], if it is known: they have to fit it, too */
  void readFrom(params::StrictSection& ini, const std::optional<double>& resolution = std::nullopt);
  /** Numbers are written such that they read the same. */
  void saveToConfigFile(mrpt::config::CConfigFileBase& target,
                        const std::string& section) const override;
  void dumpToTextStream(std::ostream& out) const override;

  void writeToStream(mrpt::serialization::CArchive& out) const;
  /** Values are not checked: a stream brings back what was written, valid or not.
   * \exception std::exception for a stream that ends or does not hold options */
  void readFromStream(mrpt::serialization::CArchive& in);
};

}  // namespace mrpt_mapconv::scan
