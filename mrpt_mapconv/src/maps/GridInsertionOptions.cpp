#include <mrpt_mapconv/maps/GridInsertionOptions.h>

#include <cstdint>
#include <limits>

namespace mrpt_mapconv::maps
{
namespace
{
using Options = mrpt::maps::COccupancyGridMap2D::TInsertionOptions;
using params::StrictSection;

bool isCertainty(float p) { return p >= 0.5f && p <= 1; }

/** A certainty for which 0 stands for that of occupied cells. */
void checkFreeCertainty(const StrictSection& ini, const char* key, float value)
{
  if (!isCertainty(value) && value != 0)
    ini.fail(key, "within [0.5, 1], or 0 for maxOccupancyUpdateCertainty");
}

void checkNotNegative(const StrictSection& ini, const char* key, float value)
{
  if (value < 0) ini.fail(key, ">= 0");
}

/** Wider than the option itself, so that what is too large can be told. */
void checkDecimation(StrictSection& ini, std::uint32_t every)
{
  constexpr std::uint32_t most = std::numeric_limits<decltype(Options::decimation)>::max();
  ini.read("decimation", every);
  if (every < 1 || every > most) ini.fail("decimation", "from 1 to " + std::to_string(most));
}

void check(const StrictSection& ini, const Options& options)
{
  if (options.maxDistanceInsertion <= 0) ini.fail("maxDistanceInsertion", "> 0");
  if (!isCertainty(options.maxOccupancyUpdateCertainty))
    ini.fail("maxOccupancyUpdateCertainty", "within [0.5, 1]");
  checkFreeCertainty(ini, "maxFreenessUpdateCertainty", options.maxFreenessUpdateCertainty);
  checkFreeCertainty(ini, "maxFreenessInvalidRanges", options.maxFreenessInvalidRanges);
  checkNotNegative(ini, "horizontalTolerance", options.horizontalTolerance);
  checkNotNegative(ini, "CFD_features_gaussian_size", options.CFD_features_gaussian_size);
  checkNotNegative(ini, "CFD_features_median_size", options.CFD_features_median_size);
}
}  // namespace

void readGridInsertionOptions(StrictSection& ini, Options& options)
{
  Options read = options;
  checkDecimation(ini, read.decimation);
  params::readFields(ini, read);
  check(ini, read);
  options = read;
}

}  // namespace mrpt_mapconv::maps
