// Makes the calls of RawLogViewer's form "build map from raw sensory data": the plugin that -l
// names is loaded, maps are made from ini text with the section prefix "map", a rawlog is inserted.
// This process is not linked to our library; it knows the map only as the MRPT class that it
// derives from, and the name of the CLASS that the ini is to make.
//
//   raw_map_form INI RAWLOG CLASS [PLUGIN]
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/TMetricMapInitializer.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/system/os.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace
{
mrpt::maps::CMultiMetricMap mapsFrom(const std::string& iniFile)
{
  std::ifstream file(iniFile);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const mrpt::config::CConfigFileMemory ini(text);  // the form holds the text in an edit box
  mrpt::maps::TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(ini, "map");
  mrpt::maps::CMultiMetricMap maps;
  maps.setListOfMaps(definitions);
  return maps;
}

void insertAll(const mrpt::obs::CRawlog& log, mrpt::maps::CMultiMetricMap& maps)
{
  const mrpt::poses::CPose3D pose;
  for (std::size_t i = 0; i < log.size(); ++i)
    if (log.getType(i) == mrpt::obs::CRawlog::etSensoryFrame)
      log.getAsObservations(i)->insertObservationsInto(maps, pose);
    else if (log.getType(i) == mrpt::obs::CRawlog::etObservation)
      maps.insertObservation(*log.getAsObservation(i), pose);
}
}  // namespace

int main(int argc, char** argv)
{
  if (argc < 4) return 2;
  if (argc > 4)
  {
    std::string error;
    if (!mrpt::system::loadPluginModules(argv[4], error))
    {
      std::printf("plugin: %s\n", error.c_str());
      return 1;
    }
  }
  auto maps = mapsFrom(argv[1]);
  const auto grid = maps.mapByClass<mrpt::maps::COccupancyGridMap2D>();
  const std::string made = grid ? grid->GetRuntimeClass()->className : "no grid map";
  if (made != argv[3])
  {
    std::printf("%s was made instead of %s\n", made.c_str(), argv[3]);
    return 1;
  }
  mrpt::obs::CRawlog log;
  if (!log.loadFromRawLogFile(argv[2]))
  {
    std::printf("%s cannot be read\n", argv[2]);
    return 1;
  }
  insertAll(log, maps);

  std::size_t free = 0, occupied = 0;
  for (const auto cell : grid->getRawMap())
  {
    free += cell > 0;
    occupied += cell < 0;
  }
  std::printf("%u x %u cells, %zu free, %zu occupied\n", grid->getSizeX(), grid->getSizeY(), free,
              occupied);
  // a lidar sees the floor around it: at 0.1 m that is some hundred cells
  return grid->isEmpty() || free < 200 || occupied < 10 ? 1 : 0;
}
