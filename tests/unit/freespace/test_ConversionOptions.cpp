#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt_mapconv/freespace/ConversionOptions.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>

#include <stdexcept>

using namespace mrpt_mapconv::freespace;
using mrpt::config::CConfigFileMemory;
using mrpt_mapconv::voxel::TVoxelInsertionOptions;
using mrpt_mapconv::voxel::Unknown;

namespace
{
std::string failure(mrpt::config::CLoadableOptions& options, const std::string& lines)
{
  const CConfigFileMemory source("[s]\n" + lines + "\n");
  try
  {
    options.loadFromConfigFile(source, "s");
    return "";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}
}  // namespace

TEST(ConversionOptions, DefaultsAreTheGroundRobotAndASafeMap)
{
  const TConversionOptions options;
  EXPECT_EQ(options.robot, Robot::Ground);
  EXPECT_EQ(options.params.minClearance, 1.0);
  EXPECT_EQ(options.params.minOccupancy, 0.5);
  EXPECT_EQ(options.params.slopeWindow, 2);
  EXPECT_EQ(options.params.maxSlope, 2.0);
  EXPECT_FALSE(options.params.maxStep);
  EXPECT_EQ(options.params.floorFrom, FloorFrom::Seen);
  EXPECT_EQ(options.params.reading.unknown, Unknown::Unknown);
}

TEST(ConversionOptions, ReadsEveryKey)
{
  TConversionOptions options;
  ASSERT_EQ(failure(options,
                    "robot=aerial\nminClearance=0.4\nminOccupancy=0.25\nslopeWindow=3\n"
                    "maxSlope=0.7\nmaxStep=0.15\nunknown=free"),
            "");
  EXPECT_EQ(options.robot, Robot::Aerial);
  EXPECT_EQ(options.params.minClearance, 0.4);
  EXPECT_EQ(options.params.minOccupancy, 0.25);
  EXPECT_EQ(options.params.slopeWindow, 3);
  EXPECT_EQ(options.params.maxSlope, 0.7);
  EXPECT_EQ(options.params.maxStep, 0.15);
  EXPECT_EQ(options.params.reading.unknown, Unknown::Free);
}

TEST(ConversionOptions, ThePapersParametersHaveAName)
{
  TConversionOptions options;
  ASSERT_EQ(failure(options, "maxStep = 0.3\npaper = true\nmaxSlope = 1"), "");
  EXPECT_EQ(options.params.maxStep, 0.3) << "a key beside it replaces its value";
  EXPECT_EQ(options.params.maxSlope, 1.0);
  EXPECT_EQ(options.params.floorFrom, FloorFrom::LowestFree);

  TConversionOptions others;
  others.params.maxStep = 0.4;
  ASSERT_EQ(failure(others, "paper = true"), "");
  EXPECT_EQ(others.params.maxStep, 0.0);
  ASSERT_EQ(failure(others, "floorFrom = seen\npaper = no\nmaxStep = auto"), "");
  EXPECT_EQ(others.params.floorFrom, FloorFrom::Seen);
  EXPECT_FALSE(others.params.maxStep);
}

TEST(ConversionOptions, ABadValueNamesSectionKeyAndValueAndChangesNothing)
{
  for (const auto& [line, named] : std::vector<std::pair<std::string, std::string>>{
           {"robot=boat", "section 's': robot = 'boat'"},
           {"minClearance=banana", "section 's': minClearance = 'banana'"},
           {"minClearance=1,5", "section 's': minClearance = '1,5'"},
           {"minClearance=-1", "section 's': minClearance = -1"},
           {"minOccupancy=1.1", "section 's': minOccupancy = 1.1"},
           {"slopeWindow=0", "section 's': slopeWindow = 0"},
           {"slopeWindow=2.5", "section 's': slopeWindow = '2.5'"},
           {"maxSlope=nan", "section 's': maxSlope = 'nan'"},
           {"maxStep=-0.1", "section 's': maxStep = -0.1"},
           {"maxStep=high",
            "section 's': maxStep = 'high' is not valid: it must be a finite number "
            "or auto"},
           {"paper=Fredriksson", "section 's': paper = 'Fredriksson'"},
           {"unknown=occupied", "section 's': unknown = 'occupied'"}})
  {
    TConversionOptions options;
    const auto message = failure(options, "minOccupancy=0.1\n" + line);
    EXPECT_EQ(message.rfind(named, 0), 0u) << message;
    EXPECT_EQ(options.params.minOccupancy, 0.5) << line;
  }
}

TEST(ConversionOptions, WritesAndReadsBack)
{
  TConversionOptions options;
  options.robot = Robot::Aerial;
  options.params = {0.4, 0.25, 3, 0.7, 0.15, {Unknown::Free}};
  mrpt::io::CMemoryStream memory;
  auto archive = mrpt::serialization::archiveFrom(memory);
  options.writeToStream(archive);
  memory.Seek(0);
  TConversionOptions read;
  read.readFromStream(archive);
  EXPECT_EQ(read.robot, Robot::Aerial);
  EXPECT_EQ(read.params.minClearance, 0.4);
  EXPECT_EQ(read.params.minOccupancy, 0.25);
  EXPECT_EQ(read.params.slopeWindow, 3);
  EXPECT_EQ(read.params.maxSlope, 0.7);
  EXPECT_EQ(read.params.maxStep, 0.15);
  EXPECT_EQ(read.params.reading.unknown, Unknown::Free);

  CConfigFileMemory ini;
  options.saveToConfigFile(ini, "x");
  TConversionOptions fromIni;
  fromIni.loadFromConfigFile(ini, "x");
  EXPECT_EQ(fromIni.robot, Robot::Aerial);
  EXPECT_EQ(fromIni.params.maxStep, 0.15);
  EXPECT_EQ(fromIni.params.reading.unknown, Unknown::Free);
}

TEST(ConversionOptions, AutoAndOffAreWrittenAndReadBack)
{
  for (const auto& step : {std::optional<double>(), std::optional<double>(0)})
  {
    TConversionOptions options, read, fromIni;
    options.params.maxStep = step;
    read.params.maxStep = fromIni.params.maxStep = 0.7;
    mrpt::io::CMemoryStream memory;
    auto archive = mrpt::serialization::archiveFrom(memory);
    options.writeToStream(archive);
    memory.Seek(0);
    read.readFromStream(archive);
    EXPECT_EQ(read.params.maxStep, step);

    CConfigFileMemory ini;
    options.saveToConfigFile(ini, "x");
    EXPECT_EQ(ini.read_string("x", "maxStep", ""), step ? "0" : "auto");
    fromIni.loadFromConfigFile(ini, "x");
    EXPECT_EQ(fromIni.params.maxStep, step);
  }
}

TEST(VoxelInsertionOptions, ReadsEveryKeyNamedAsInCOctoMap)
{
  TVoxelInsertionOptions options;
  ASSERT_EQ(failure(options,
                    "maxrange=12\npruning=false\noccupancyThres=0.6\nprobHit=0.8\n"
                    "probMiss=0.3\nclampingThresMin=0.2\nclampingThresMax=0.9\n"
                    "insert2D=no"),
            "");
  EXPECT_EQ(options.maxrange, 12);
  EXPECT_FALSE(options.pruning);
  EXPECT_EQ(options.occupancyThres, 0.6);
  EXPECT_EQ(options.probHit, 0.8);
  EXPECT_EQ(options.probMiss, 0.3);
  EXPECT_EQ(options.clampingThresMin, 0.2);
  EXPECT_EQ(options.clampingThresMax, 0.9);
  EXPECT_FALSE(options.insert2D);
}

TEST(VoxelInsertionOptions, ABadValueIsAnError)
{
  for (const char* line :
       {"maxrange=0", "maxrange=-5", "maxrange=far", "probHit=1.2", "probHit=0.3", "probMiss=0.7",
        "occupancyThres=1.2", "clampingThresMin=0.98", "pruning=perhaps"})
  {
    TVoxelInsertionOptions options;
    const auto message = failure(options, line);
    const std::string key(line, std::string(line).find('='));
    EXPECT_NE(message.find("section 's': "), std::string::npos) << line;
    // a minimum above the maximum is told of the maximum
    const auto named = key == "clampingThresMin" ? "clampingThresMax" : key;
    EXPECT_NE(message.find(named + " = "), std::string::npos) << message;
  }
}
