#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/core/bits_math.h>
#include <mrpt_mapconv/scan/ScanInsertionOptions.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace mrpt_mapconv::scan
{
const std::vector<std::string>& modelNames()
{
  static const std::vector<std::string> names{"wholeShape", "closestPoint"};
  return names;
}

const std::string& nameOf(scan::Model model)
{
  return modelNames().at(static_cast<std::size_t>(model));
}

namespace
{
constexpr std::uint8_t kStreamVersion = 0;

void readModel(params::StrictSection& ini, scan::Model& model)
{
  int index = static_cast<int>(model);
  ini.readChoice("model", modelNames(), index);
  model = static_cast<scan::Model>(index);
}

/** What another key, or its default, asks of a value. */
std::string beside(const char* right, const char* key, double value)
{
  std::ostringstream text;
  text << right << " " << key << " = " << value << " m";
  return text.str();
}

/** The object slice; its upper end is the robot's height, by either name. */
void readObjectSlice(params::StrictSection& ini, scan::ProfileParams& params)
{
  const char* upper = ini.has("robotHeight") ? "robotHeight" : "objectMaxZ";
  ini.read("objectMinZ", params.objectMinZ);
  ini.read("robotHeight", params.objectMaxZ);
  const double height = params.objectMaxZ;
  ini.read("objectMaxZ", params.objectMaxZ);
  if (ini.has("robotHeight") && height != params.objectMaxZ)
    ini.fail("robotHeight", beside("left out, or the same as", "objectMaxZ", params.objectMaxZ));
  if (!(params.objectMaxZ <= params.objectMinZ)) return;
  // who wrote one end only is to read of that one
  if (ini.has(upper)) ini.fail(upper, beside("above", "objectMinZ", params.objectMinZ));
  if (ini.has("objectMinZ"))
    ini.fail("objectMinZ", beside("below", "objectMaxZ", params.objectMaxZ));
}

void readRanges(params::StrictSection& ini, scan::ProfileParams& params)
{
  ini.read("minRange", params.minRange);
  ini.read("maxRange", params.maxRange);
  if (ini.has("maxRange") && !ini.has("minRange") && params.maxRange <= params.minRange)
    ini.fail("maxRange", beside("above", "minRange", params.minRange));
}

constexpr double kDefaultGap = -1;

double gapInDegrees(double gap) { return gap == kDefaultGap ? gap : mrpt::RAD2DEG(gap); }

void readGap(params::StrictSection& ini, double& gap)
{
  double degrees = gapInDegrees(gap);
  ini.read("structureGap", degrees);
  if (!ini.has("structureGap")) return;
  if (degrees != kDefaultGap && !(degrees >= 0 && degrees <= 180))
    ini.fail("structureGap", "from 0 to 180 degrees, or -1 for the default");
  gap = degrees == kDefaultGap ? kDefaultGap : mrpt::DEG2RAD(degrees);
}

void readProfile(params::StrictSection& ini, scan::ProfileParams& params)
{
  readModel(ini, params.model);
  readObjectSlice(ini, params);
  ini.read("reflectionFilter", params.reflectionFilter);
  ini.read("structureMinZ", params.structureMinZ);
  ini.read("structureMaxZ", params.structureMaxZ);
  readRanges(ini, params);
  ini.read("sectors", params.sectors);
  readGap(ini, params.structureGap);
  ini.read("structureTolerance", params.structureTolerance);
}

void readUpdate(params::StrictSection& ini, scan::UpdateParams& params)
{
  ini.read("pHit", params.pHit);
  ini.read("pMiss", params.pMiss);
  ini.read("pMin", params.pMin);
  ini.read("pMax", params.pMax);
}

/** Writes the fewest digits that read the same; MRPT's own writing rounds. */
void writeExactly(mrpt::config::CConfigFileBase& target, const std::string& section,
                  const char* key, double value)
{
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  target.write(section, key, std::string(text.data(), end));
}
}  // namespace

void TScanInsertionOptions::check() const
{
  profile.check();
  update.check();
}

/** A profile of no points asks no more than what one of any scan would. */
void TScanInsertionOptions::check(double resolution) const
{
  check();
  const mrpt::poses::CPose3D sensor(0, 0, profile.objectMinZ);
  scan::ScanProfile().compute({}, {sensor, 0, 0}, resolution, profile);
}

void TScanInsertionOptions::readFrom(params::StrictSection& ini,
                                     const std::optional<double>& resolution)
{
  TScanInsertionOptions read = *this;
  readProfile(ini, read.profile);
  readUpdate(ini, read.update);
  ini.read("insert2D", read.insert2D);
  try
  {
    resolution ? read.check(*resolution) : read.check();
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error("section '" + ini.name() + "': " + error.what());
  }
  *this = read;
}

void TScanInsertionOptions::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                               const std::string& section)
{
  params::StrictSection ini(source, section);
  readFrom(ini);
  ini.warnUnknown();
}

void TScanInsertionOptions::saveToConfigFile(mrpt::config::CConfigFileBase& target,
                                             const std::string& section) const
{
  target.write(section, "model", nameOf(profile.model));
  writeExactly(target, section, "objectMinZ", profile.objectMinZ);
  writeExactly(target, section, "objectMaxZ", profile.objectMaxZ);
  target.write(section, "reflectionFilter", profile.reflectionFilter);
  if (!std::isnan(profile.structureMinZ))
    writeExactly(target, section, "structureMinZ", profile.structureMinZ);
  if (!std::isnan(profile.structureMaxZ))
    writeExactly(target, section, "structureMaxZ", profile.structureMaxZ);
  writeExactly(target, section, "minRange", profile.minRange);
  writeExactly(target, section, "maxRange", profile.maxRange);
  target.write(section, "sectors", profile.sectors);
  writeExactly(target, section, "structureGap", gapInDegrees(profile.structureGap));
  writeExactly(target, section, "structureTolerance", profile.structureTolerance);
  writeExactly(target, section, "pHit", update.pHit);
  writeExactly(target, section, "pMiss", update.pMiss);
  writeExactly(target, section, "pMin", update.pMin);
  writeExactly(target, section, "pMax", update.pMax);
  target.write(section, "insert2D", insert2D);
}

void TScanInsertionOptions::dumpToTextStream(std::ostream& out) const
{
  out << "\n----------- [mrpt_mapconv TScanInsertionOptions] ------------ \n\n";
  out << "model                                   = " << nameOf(profile.model) << "\n";
  dumpVar_double(out, "objectMinZ", profile.objectMinZ);
  dumpVar_double(out, "objectMaxZ", profile.objectMaxZ);
  dumpVar_bool(out, "reflectionFilter", profile.reflectionFilter);
  dumpVar_double(out, "structureMinZ", profile.structureMinZ);
  dumpVar_double(out, "structureMaxZ", profile.structureMaxZ);
  dumpVar_double(out, "minRange", profile.minRange);
  dumpVar_double(out, "maxRange", profile.maxRange);
  dumpVar_int(out, "sectors", profile.sectors);
  dumpVar_double(out, "structureGap", gapInDegrees(profile.structureGap));
  dumpVar_double(out, "structureTolerance", profile.structureTolerance);
  dumpVar_double(out, "pHit", update.pHit);
  dumpVar_double(out, "pMiss", update.pMiss);
  dumpVar_double(out, "pMin", update.pMin);
  dumpVar_double(out, "pMax", update.pMax);
  dumpVar_bool(out, "insert2D", insert2D);
}

void TScanInsertionOptions::writeToStream(mrpt::serialization::CArchive& out) const
{
  out << kStreamVersion << static_cast<std::uint8_t>(profile.model) << profile.objectMinZ
      << profile.objectMaxZ << profile.reflectionFilter << profile.structureMinZ
      << profile.structureMaxZ << profile.minRange << profile.maxRange << profile.sectors
      << profile.structureGap << profile.structureTolerance << update.pHit << update.pMiss
      << update.pMin << update.pMax << insert2D;
}

void TScanInsertionOptions::readFromStream(mrpt::serialization::CArchive& in)
{
  std::uint8_t version = 0, model = 0;
  TScanInsertionOptions read;
  in >> version;
  if (version != kStreamVersion)
    throw std::runtime_error("scan insertion options: unknown version " + std::to_string(version));
  in >> model >> read.profile.objectMinZ >> read.profile.objectMaxZ >>
      read.profile.reflectionFilter >> read.profile.structureMinZ >> read.profile.structureMaxZ >>
      read.profile.minRange >> read.profile.maxRange >> read.profile.sectors >>
      read.profile.structureGap >> read.profile.structureTolerance >> read.update.pHit >>
      read.update.pMiss >> read.update.pMin >> read.update.pMax >> read.insert2D;
  if (model >= modelNames().size())
    throw std::runtime_error("scan insertion options: unknown model " + std::to_string(model));
  read.profile.model = static_cast<scan::Model>(model);
  *this = read;
}

}  // namespace mrpt_mapconv::scan
