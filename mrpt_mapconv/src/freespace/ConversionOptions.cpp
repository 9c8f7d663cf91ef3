#include <mrpt/config/CConfigFileBase.h>
#include <mrpt_mapconv/freespace/ConversionOptions.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <stdexcept>

namespace mrpt_mapconv::freespace
{
namespace
{
const std::vector<std::string>& robotNames()
{
  static const std::vector<std::string> names{"ground", "aerial"};
  return names;
}
constexpr std::uint8_t kStreamVersion = 0;
}  // namespace

void TConversionOptions::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                            const std::string& section)
{
  TConversionOptions read = *this;
  params::StrictSection ini(source, section);
  int robotIndex = static_cast<int>(robot);
  ini.readChoice("robot", robotNames(), robotIndex);
  read.robot = static_cast<Robot>(robotIndex);
  ini.read("minClearance", read.params.minClearance);
  ini.read("minOccupancy", read.params.minOccupancy);
  ini.read("slopeWindow", read.params.slopeWindow);
  ini.read("maxSlope", read.params.maxSlope);
  ini.read("maxStep", read.params.maxStep);
  try
  {
    read.params.check();
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error("section '" + section + "': " + error.what());
  }
  ini.warnUnknown();
  *this = read;
}

void TConversionOptions::saveToConfigFile(mrpt::config::CConfigFileBase& target,
                                          const std::string& section) const
{
  target.write(section, "robot", robotNames()[static_cast<std::size_t>(robot)]);
  target.write(section, "minClearance", params.minClearance);
  target.write(section, "minOccupancy", params.minOccupancy);
  target.write(section, "slopeWindow", params.slopeWindow);
  target.write(section, "maxSlope", params.maxSlope);
  target.write(section, "maxStep", params.maxStep);
}

void TConversionOptions::dumpToTextStream(std::ostream& out) const
{
  out << "\n----------- [mrpt_mapconv TConversionOptions] ------------ \n\n";
  out << "robot                                   = "
      << robotNames()[static_cast<std::size_t>(robot)] << "\n";
  dumpVar_double(out, "minClearance", params.minClearance);
  dumpVar_double(out, "minOccupancy", params.minOccupancy);
  dumpVar_int(out, "slopeWindow", params.slopeWindow);
  dumpVar_double(out, "maxSlope", params.maxSlope);
  dumpVar_double(out, "maxStep", params.maxStep);
}

void TConversionOptions::writeToStream(mrpt::serialization::CArchive& out) const
{
  out << kStreamVersion << static_cast<std::uint8_t>(robot) << params.minClearance
      << params.minOccupancy << params.slopeWindow << params.maxSlope << params.maxStep;
}

void TConversionOptions::readFromStream(mrpt::serialization::CArchive& in)
{
  std::uint8_t version = 0, robotIndex = 0;
  TConversionOptions read;
  in >> version;
  if (version != kStreamVersion)
    throw std::runtime_error("conversion options: unknown version " + std::to_string(version));
  in >> robotIndex >> read.params.minClearance >> read.params.minOccupancy >>
      read.params.slopeWindow >> read.params.maxSlope >> read.params.maxStep;
  if (robotIndex >= robotNames().size())
    throw std::runtime_error("conversion options: unknown robot " + std::to_string(robotIndex));
  read.robot = static_cast<Robot>(robotIndex);
  read.params.check();
  *this = read;
}

}  // namespace mrpt_mapconv::freespace
