#include <mrpt/config/CConfigFileBase.h>
#include <mrpt_mapconv/maps/GridLikelihoodOptions.h>
#include <mrpt_mapconv/maps/StrictSection.h>

namespace mrpt_mapconv::maps
{
namespace
{
template <class Number>
void checkNotNegative(StrictSection& ini, std::initializer_list<const char*> keys)
{
  for (const char* key : keys)
  {
    Number value = 0;
    ini.read(key, value);
    if (value < 0) ini.fail(key, "≥ 0");
  }
}
}  // namespace

void loadGridLikelihoodOptions(const mrpt::config::CConfigFileBase& source,
                               const std::string& section,
                               mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions& options)
{
  StrictSection ini(source, section);
  int method = 0;
  // MRPT takes a method's name or its number
  ini.readChoice("likelihoodMethod",
                 {"lmMeanInformation", "lmRayTracing", "lmConsensus", "lmCellsDifference",
                  "lmLikelihoodField_Thrun", "lmLikelihoodField_II", "lmConsensusOWA", "0", "1",
                  "2", "3", "4", "5", "6"},
                 method);
  checkNotNegative<double>(
      ini, {"LF_stdHit", "LF_zHit", "LF_zRandom", "LF_maxRange", "LF_maxCorrsDistance",
            "MI_exponent", "MI_ratio_max_distance", "rayTracing_stdHit", "consensus_pow"});
  checkNotNegative<std::int32_t>(
      ini, {"LF_decimation", "MI_skip_rays", "rayTracing_decimation", "consensus_takeEachRange"});
  bool flag = false;
  for (const char* key : {"enableLikelihoodCache", "LF_useSquareDist", "LF_alternateAverageMethod",
                          "rayTracing_useDistanceFilter"})
    ini.read(key, flag);
  ini.ignore("OWA_weights");  // a list, which MRPT reads
  ini.warnUnknown();
  options.loadFromConfigFile(source, section);
}

}  // namespace mrpt_mapconv::maps
