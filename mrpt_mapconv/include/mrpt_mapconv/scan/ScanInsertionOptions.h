#pragma once

#include <mrpt_mapconv/params/ListedOptions.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>
#include <mrpt_mapconv/scan/ProfileParams.h>

#include <optional>
#include <string>

namespace mrpt_mapconv::scan
{
/** How 3D scans are inserted into a CScanShapeGridMap2D.
 *
 * In an ini file `robotHeight` is another name of objectMaxZ; structureGap is in degrees. */
struct TScanInsertionOptions : public params::ListedOptions<TScanInsertionOptions>
{
  static constexpr const char* kName = "TScanInsertionOptions";
  static constexpr const char* kStreamName = "scan insertion options";
  static constexpr std::uint8_t kStreamVersion = 0;

  ProfileParams profile;
  UpdateParams update;
  bool insert2D = true;  //!< insert 2D range scans, too, as MRPT's own grid does

  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    ProfileParams::visit(o.profile, v);
    UpdateParams::visit(o.update, v);
    v("insert2D", o.insert2D, "", "insert 2D range scans, too, as MRPT's own grid does");
  }
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
};

}  // namespace mrpt_mapconv::scan
