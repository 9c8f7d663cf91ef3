#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Robot.h>

namespace mrpt_mapconv::freespace
{
using freespace::Robot;

/** Options of the free-space projection as MRPT reads and prints them; in an ini file: robot
 * (ground|aerial), minClearance, minOccupancy, slopeWindow, maxSlope, maxStep. */
struct TConversionOptions : public mrpt::config::CLoadableOptions
{
  Robot robot = Robot::Ground;
  freespace::ConversionParams params;

  /** Reads the keys that are there; warns about others.
   * \exception std::runtime_error naming section, key and value; the options then stay as they were
   */
  void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                          const std::string& section) override;
  void saveToConfigFile(mrpt::config::CConfigFileBase& target,
                        const std::string& section) const override;
  void dumpToTextStream(std::ostream& out) const override;

  void writeToStream(mrpt::serialization::CArchive& out) const;
  /** \exception std::exception for a stream that does not hold valid options */
  void readFromStream(mrpt::serialization::CArchive& in);
};

}  // namespace mrpt_mapconv::freespace
