#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/maps/GridLikelihoodOptions.h>
#include <mrpt_mapconv/params/StrictSection.h>

namespace mrpt_mapconv::maps
{
namespace
{
/** Copies options that are valid into an ini of our own, for MRPT to read: with MRPT's looser rules
 * "true ; why" would be false. */
class Sieve
{
 public:
  Sieve(const mrpt::config::CConfigFileBase& source, const std::string& section)
      : m_ini(source, section)
  {
  }

  template <class Number>
  void notNegative(std::initializer_list<const char*> keys)
  {
    for (const char* key : keys)
      number<Number>(
          key, [](Number n) { return n >= 0; }, ">= 0");
  }
  template <class Number>
  void positive(std::initializer_list<const char*> keys)
  {
    for (const char* key : keys)
      number<Number>(
          key, [](Number n) { return n > 0; }, "> 0");
  }
  void flags(std::initializer_list<const char*> keys)
  {
    for (const char* key : keys)
    {
      bool flag = false;
      m_ini.read(key, flag);
      if (m_ini.has(key)) m_clean.write(kSection, key, flag);
    }
  }
  void choice(const char* key, const std::vector<std::string>& choices)
  {
    int index = 0;
    m_ini.readChoice(key, choices, index);
    if (m_ini.has(key)) m_clean.write(kSection, key, choices[static_cast<std::size_t>(index)]);
  }
  void weights(const char* key)
  {
    std::vector<double> numbers;
    m_ini.read(key, numbers);
    if (!m_ini.has(key)) return;
    std::string list;
    for (const double n : numbers)
    {
      if (n < 0) m_ini.fail(key, "numbers >= 0");
      list += (list.empty() ? "" : " ") + mrpt::format("%.9g", n);
    }
    m_clean.write(kSection, key, list);
  }
  void loadInto(mrpt::config::CLoadableOptions& options)
  {
    m_ini.warnUnknown();
    options.loadFromConfigFile(m_clean, kSection);
  }

 private:
  template <class Number, class Valid>
  void number(const char* key, const Valid& valid, const char* right)
  {
    Number value{};
    m_ini.read(key, value);
    if (!m_ini.has(key)) return;
    if (!valid(value)) m_ini.fail(key, right);
    m_clean.write(kSection, key, mrpt::format("%.9g", static_cast<double>(value)));
  }

  static constexpr const char* kSection = "likelihood";
  params::StrictSection m_ini;
  mrpt::config::CConfigFileMemory m_clean;
};
}  // namespace

void loadGridLikelihoodOptions(const mrpt::config::CConfigFileBase& source,
                               const std::string& section,
                               mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions& options)
{
  Sieve sieve(source, section);
  // MRPT takes a method's name or its number
  sieve.choice("likelihoodMethod",
               {"lmMeanInformation", "lmRayTracing", "lmConsensus", "lmCellsDifference",
                "lmLikelihoodField_Thrun", "lmLikelihoodField_II", "lmConsensusOWA", "0", "1", "2",
                "3", "4", "5", "6"});
  // MRPT divides by these, or steps by them
  sieve.positive<float>({"LF_stdHit", "LF_maxRange", "LF_maxCorrsDistance", "rayTracing_stdHit"});
  sieve.positive<std::int32_t>(
      {"LF_decimation", "MI_skip_rays", "rayTracing_decimation", "consensus_takeEachRange"});
  sieve.notNegative<float>(
      {"LF_zHit", "LF_zRandom", "MI_exponent", "MI_ratio_max_distance", "consensus_pow"});
  sieve.flags({"enableLikelihoodCache", "LF_useSquareDist", "LF_alternateAverageMethod",
               "rayTracing_useDistanceFilter"});
  sieve.weights("OWA_weights");
  sieve.loadInto(options);
}

}  // namespace mrpt_mapconv::maps
