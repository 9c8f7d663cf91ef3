#include <mrpt_mapconv/maps/GridInsertionOptions.h>

#include <cstdint>
#include <limits>

namespace mrpt_mapconv::maps
{
namespace
{
using Options = mrpt::maps::COccupancyGridMap2D::TInsertionOptions;

bool isCertainty(float p) { return p >= 0.5f && p <= 1; }

/** A certainty for which 0 stands for that of occupied cells. */
void readFreeCertainty(params::StrictSection& ini, const char* key, float& value)
{
  ini.read(key, value);
  if (!isCertainty(value) && value != 0)
    ini.fail(key, "within [0.5, 1], or 0 for maxOccupancyUpdateCertainty");
}

void readNotNegative(params::StrictSection& ini, const char* key, float& value)
{
  ini.read(key, value);
  if (value < 0) ini.fail(key, ">= 0");
}

void readDecimation(params::StrictSection& ini, Options& options)
{
  constexpr std::uint32_t most = std::numeric_limits<decltype(options.decimation)>::max();
  std::uint32_t every = options.decimation;
  ini.read("decimation", every);
  if (every < 1 || every > most) ini.fail("decimation", "from 1 to " + std::to_string(most));
  options.decimation = static_cast<std::uint16_t>(every);
}

void readTolerance(params::StrictSection& ini, Options& options)
{
  if (!ini.has("horizontalTolerance")) return;
  float degrees = 0;
  readNotNegative(ini, "horizontalTolerance", degrees);
  options.horizontalTolerance = mrpt::DEG2RAD(degrees);
}
}  // namespace

void readGridInsertionOptions(params::StrictSection& ini, Options& options)
{
  Options read = options;
  ini.read("mapAltitude", read.mapAltitude);
  ini.read("useMapAltitude", read.useMapAltitude);
  ini.read("maxDistanceInsertion", read.maxDistanceInsertion);
  if (read.maxDistanceInsertion <= 0) ini.fail("maxDistanceInsertion", "> 0");
  ini.read("maxOccupancyUpdateCertainty", read.maxOccupancyUpdateCertainty);
  if (!isCertainty(read.maxOccupancyUpdateCertainty))
    ini.fail("maxOccupancyUpdateCertainty", "within [0.5, 1]");
  readFreeCertainty(ini, "maxFreenessUpdateCertainty", read.maxFreenessUpdateCertainty);
  readFreeCertainty(ini, "maxFreenessInvalidRanges", read.maxFreenessInvalidRanges);
  ini.read("considerInvalidRangesAsFreeSpace", read.considerInvalidRangesAsFreeSpace);
  readDecimation(ini, read);
  readTolerance(ini, read);
  readNotNegative(ini, "CFD_features_gaussian_size", read.CFD_features_gaussian_size);
  readNotNegative(ini, "CFD_features_median_size", read.CFD_features_median_size);
  ini.read("wideningBeamsWithDistance", read.wideningBeamsWithDistance);
  options = read;
}

}  // namespace mrpt_mapconv::maps
