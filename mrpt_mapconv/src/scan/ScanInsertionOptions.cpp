#include <mrpt_mapconv/scan/ScanInsertionOptions.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <sstream>

namespace mrpt_mapconv::scan
{
using params::StrictSection;

namespace
{
/** What another key, or its default, asks of a value. */
std::string beside(const char* right, const char* key, double value)
{
  std::ostringstream text;
  text << right << " " << key << " = " << value << " m";
  return text.str();
}

/** The object slice's upper end is the robot's height, by either name. Who wrote one end only is to
 * read of that one. */
void checkObjectSlice(StrictSection& ini, ProfileParams& params)
{
  const char* upper = ini.has("robotHeight") ? "robotHeight" : "objectMaxZ";
  double height = params.objectMaxZ;
  ini.read("robotHeight", height);
  if (ini.has("objectMaxZ") && height != params.objectMaxZ)
    ini.fail("robotHeight", beside("left out, or the same as", "objectMaxZ", params.objectMaxZ));
  params.objectMaxZ = height;
  if (!(params.objectMaxZ <= params.objectMinZ)) return;
  if (ini.has(upper)) ini.fail(upper, beside("above", "objectMinZ", params.objectMinZ));
  if (ini.has("objectMinZ"))
    ini.fail("objectMinZ", beside("below", "objectMaxZ", params.objectMaxZ));
}

void checkRanges(StrictSection& ini, const ProfileParams& params)
{
  if (ini.has("maxRange") && !ini.has("minRange") && params.maxRange <= params.minRange)
    ini.fail("maxRange", beside("above", "minRange", params.minRange));
}

void checkGap(StrictSection& ini)
{
  double degrees = -1;
  ini.read("structureGap", degrees);
  if (degrees != -1 && !(degrees >= 0 && degrees <= 180))
    ini.fail("structureGap", "from 0 to 180 degrees, or -1 for the default");
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
  ScanProfile().compute({}, {sensor, 0, 0}, resolution, profile);
}

void TScanInsertionOptions::readFrom(StrictSection& ini, const std::optional<double>& resolution)
{
  TScanInsertionOptions read = *this;
  params::readFields(ini, read);
  checkObjectSlice(ini, read.profile);
  checkRanges(ini, read.profile);
  checkGap(ini);
  ini.checked([&] { resolution ? read.check(*resolution) : read.check(); });
  *this = read;
}

void TScanInsertionOptions::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                               const std::string& section)
{
  StrictSection ini(source, section);
  readFrom(ini);
  ini.warnUnknown();
}

}  // namespace mrpt_mapconv::scan
