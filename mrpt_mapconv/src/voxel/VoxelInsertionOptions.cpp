#include <mrpt/config/CConfigFileBase.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/params/StrictSection.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <stdexcept>

namespace mrpt_mapconv::voxel
{
using params::require;

namespace
{
constexpr std::uint8_t kStreamVersion = 0;

bool isProbability(double p) { return p >= 0 && p <= 1; }
}  // namespace

void TVoxelInsertionOptions::check() const
{
  require(std::isfinite(maxrange) && (maxrange > 0 || maxrange == -1), "maxrange", maxrange,
          "a range > 0 m, or -1 for no limit");
  require(isProbability(occupancyThres), "occupancyThres", occupancyThres, "within [0, 1]");
  require(isProbability(probHit) && probHit >= 0.5, "probHit", probHit, "within [0.5, 1]");
  require(isProbability(probMiss) && probMiss <= 0.5, "probMiss", probMiss, "within [0, 0.5]");
  require(isProbability(clampingThresMin), "clampingThresMin", clampingThresMin, "within [0, 1]");
  require(isProbability(clampingThresMax) && clampingThresMax > clampingThresMin,
          "clampingThresMax", clampingThresMax, "above clampingThresMin and at most 1");
}

void TVoxelInsertionOptions::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                                const std::string& section)
{
  TVoxelInsertionOptions read = *this;
  params::StrictSection ini(source, section);
  ini.read("maxrange", read.maxrange);
  ini.read("pruning", read.pruning);
  ini.read("occupancyThres", read.occupancyThres);
  ini.read("probHit", read.probHit);
  ini.read("probMiss", read.probMiss);
  ini.read("clampingThresMin", read.clampingThresMin);
  ini.read("clampingThresMax", read.clampingThresMax);
  ini.read("insert2D", read.insert2D);
  try
  {
    read.check();
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error("section '" + section + "': " + error.what());
  }
  ini.warnUnknown();
  *this = read;
}

void TVoxelInsertionOptions::saveToConfigFile(mrpt::config::CConfigFileBase& target,
                                              const std::string& section) const
{
  target.write(section, "maxrange", maxrange);
  target.write(section, "pruning", pruning);
  target.write(section, "occupancyThres", occupancyThres);
  target.write(section, "probHit", probHit);
  target.write(section, "probMiss", probMiss);
  target.write(section, "clampingThresMin", clampingThresMin);
  target.write(section, "clampingThresMax", clampingThresMax);
  target.write(section, "insert2D", insert2D);
}

void TVoxelInsertionOptions::dumpToTextStream(std::ostream& out) const
{
  out << "\n----------- [mrpt_mapconv TVoxelInsertionOptions] ------------ \n\n";
  dumpVar_double(out, "maxrange", maxrange);
  dumpVar_bool(out, "pruning", pruning);
  dumpVar_double(out, "occupancyThres", occupancyThres);
  dumpVar_double(out, "probHit", probHit);
  dumpVar_double(out, "probMiss", probMiss);
  dumpVar_double(out, "clampingThresMin", clampingThresMin);
  dumpVar_double(out, "clampingThresMax", clampingThresMax);
  dumpVar_bool(out, "insert2D", insert2D);
}

void TVoxelInsertionOptions::writeToStream(mrpt::serialization::CArchive& out) const
{
  out << kStreamVersion << maxrange << pruning << occupancyThres << probHit << probMiss
      << clampingThresMin << clampingThresMax << insert2D;
}

void TVoxelInsertionOptions::readFromStream(mrpt::serialization::CArchive& in)
{
  std::uint8_t version = 0;
  TVoxelInsertionOptions read;
  in >> version;
  if (version != kStreamVersion)
    throw std::runtime_error("voxel insertion options: unknown version " + std::to_string(version));
  in >> read.maxrange >> read.pruning >> read.occupancyThres >> read.probHit >> read.probMiss >>
      read.clampingThresMin >> read.clampingThresMax >> read.insert2D;
  *this = read;
}

void TVoxelInsertionOptions::applyTo(octomap::OcTree& tree) const
{
  tree.setOccupancyThres(occupancyThres);
  tree.setProbHit(probHit);
  tree.setProbMiss(probMiss);
  tree.setClampingThresMin(clampingThresMin);
  tree.setClampingThresMax(clampingThresMax);
}

void TVoxelInsertionOptions::adoptFrom(const octomap::OcTree& tree)
{
  occupancyThres = tree.getOccupancyThres();
  probHit = tree.getProbHit();
  probMiss = tree.getProbMiss();
  clampingThresMin = tree.getClampingThresMin();
  clampingThresMax = tree.getClampingThresMax();
}

}  // namespace mrpt_mapconv::voxel
