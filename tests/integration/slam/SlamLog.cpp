#include "SlamLog.h"

#include <mrpt/img/CImage.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/math/CMatrixF.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/eval/LabelScore.h>
#include <mrpt_mapconv/eval/OccupancyScore.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/sim/SimulationFiles.h>
#include <mrpt_mapconv/sim/Truth.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace mrpt_mapconv::testing
{
namespace
{
const std::string kWorld =
    std::string(MRPT_MAPCONV_SOURCE_DIR) + "/tests/integration/slam/flat.ini";

void simulateInto(const std::string& dir)
{
  const auto scenario = sim::Scenario::load(kWorld);
  files::OutputDir out(dir);
  sim::simulateTo(out, scenario, 1);
  out.commit();
}

bool is3D(const mrpt::serialization::CSerializable& object)
{
  return object.GetRuntimeClass() == CLASS_ID(mrpt::obs::CObservationPointCloud);
}

mrpt::obs::CSensoryFrame::Ptr without3D(const mrpt::obs::CSensoryFrame& frame)
{
  auto rest = mrpt::obs::CSensoryFrame::Create();
  for (const auto& observation : frame)
    if (!is3D(*observation)) rest->insert(observation);
  return rest;
}

void strip(const std::string& rawlogFile)
{
  mrpt::obs::CRawlog all, rest;
  if (!all.loadFromRawLogFile(rawlogFile)) throw std::runtime_error(rawlogFile);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const auto entry = all.getAsGeneric(i);
    if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(entry))
      rest.insert(*without3D(*frame));
    else if (const auto action = std::dynamic_pointer_cast<mrpt::obs::CActionCollection>(entry))
      rest.insert(*action);
    else if (!is3D(*entry))
      rest.insert(entry);
  }
  if (!rest.saveToRawLogFile(rawlogFile)) throw std::runtime_error(rawlogFile);
}

void stripSimpleMap(const std::string& file)
{
  mrpt::maps::CSimpleMap all, rest;
  if (!all.loadFromFile(file)) throw std::runtime_error(file);
  for (const auto& frame : all) rest.insert(frame.pose, without3D(*frame.sf));
  if (!rest.saveToFile(file)) throw std::runtime_error(file);
}

/** A line "t,x,y,z,yaw,pitch,roll". */
mrpt::poses::CPose2D poseOf(const std::string& line)
{
  std::istringstream text(line);
  std::vector<double> numbers;
  for (std::string number; std::getline(text, number, ',');) numbers.push_back(std::stod(number));
  return {numbers.at(1), numbers.at(2), numbers.at(4)};
}

std::int32_t wholeCells(double metres, double resolution)
{
  const double cells = metres / resolution;
  EXPECT_NEAR(cells, std::round(cells), 1e-6) << "flat.ini: the start must lie on a whole cell";
  return static_cast<std::int32_t>(std::lround(cells));
}
}  // namespace

SlamLog::SlamLog()
{
  simulateInto(m_dir.path());
  std::istringstream lines(readBytes(file("trajectory.csv")));
  std::string line;
  std::getline(lines, line);  // the columns' names
  std::getline(lines, line);
  m_first = poseOf(line);
  while (std::getline(lines, line)) m_last = poseOf(line);
}

void SlamLog::remove3D()
{
  strip(file("scans.rawlog"));
  strip(file("frames.rawlog"));
  stripSimpleMap(file("scans.simplemap"));
}

int SlamLog::run(const std::string& command) const
{
  const std::string whole =
      "cd '" + m_dir.path() + "' && timeout 200 " + command + " </dev/null >said 2>&1";
  const int status = std::system(whole.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string SlamLog::said() const
{
  constexpr std::size_t enough = 4000;
  const auto text = readBytes(file("said"));
  return text.size() > enough ? text.substr(text.size() - enough) : text;
}

void SlamLog::expectRight(const grid::Layer<float>& ground, const std::string& name) const
{
  const auto truth = grid::readGeoTiffBand(file("truth.tif"), "ground");
  const auto judged = eval::cellsFrom(grid::readGeoTiffBand(file("truth.tif"), "inView"), 1);
  const auto near = eval::scoreWithinOneCell(ground, truth, judged);
  expectAll(name, {{"rightWithinOneCell", eval::shareRightWithinOneCell(ground, truth, judged), 0.9,
                    "0.948 to 0.987"},
                   {"right", eval::shareRight(ground, truth, judged), 0.75, "0.806 to 0.889"},
                   {"freePrecision", near.free.precision(), 0.95, "0.991 to 1"},
                   {"freeRecall", near.free.recall(), 0.95, "0.973 to 0.992"},
                   {"occupiedPrecision", near.occupied.precision(), 0.6, "0.660 to 0.859"},
                   {"occupiedRecall", near.occupied.recall(), 0.75, "0.816 to 0.980"}});
}

void SlamLog::expectAll(const std::string& name, const std::vector<Demand>& demands)
{
  for (const auto& [what, share, least, measured] : demands)
  {
    ::testing::Test::RecordProperty(name + '.' + what, std::to_string(share));
    EXPECT_GE(share, least) << name << ' ' << what << "; the programs have reached " << measured;
  }
}

void SlamLog::expectRight(const std::string& layersTif, bool inStartFrame) const
{
  ASSERT_TRUE(std::filesystem::exists(file(layersTif))) << layersTif << '\n' << said();
  const auto ground = grid::readGeoTiffBand(file(layersTif), "ground");
  expectRight(inStartFrame ? movedToWorld(ground) : ground, layersTif);
}

void SlamLog::expectRightShape(const std::string& occupancyTif, bool inStartFrame) const
{
  ASSERT_TRUE(std::filesystem::exists(file(occupancyTif))) << occupancyTif << '\n' << said();
  auto map = grid::readGeoTiffBand(file(occupancyTif), "occupancy");
  for (float& cell : map.cells())
    cell = std::isnan(cell) ? grid::kUnknown : cell < 0.5f ? grid::kFree : 1.0f;
  if (inStartFrame) map = movedToWorld(map);

  const auto scenario = sim::Scenario::load(kWorld);
  constexpr double zMin = 0.05, zMax = 1.5;  // the object slice in config/scanShapeGrid/*.ini
  const auto truth = sim::obstacleLayer(
      scenario.world, sim::frameOf(scenario.world, map.frame().resolution), zMin, zMax);
  const auto judged = eval::cellsToLabel(truth, m_first.x(), m_first.y());
  const auto near = eval::scoreWithinOneCell(map, truth, judged);
  const auto exact = eval::scoreOccupancy(map, truth, judged);
  // Furniture is seen over, and this lidar's rays are too far apart to fill it: its insides are
  // free.
  expectAll(occupancyTif, {{"freeRight", exact.free.precision(), 0.9, "0.961 to 0.981"},
                           {"freePrecision", near.free.precision(), 0.95, "1"},
                           {"freeRecall", near.free.recall(), 0.95, "0.989 to 1"},
                           {"occupiedPrecision", near.occupied.precision(), 0.6, "0.727 to 1"},
                           {"occupiedRecall", near.occupied.recall(), 0.65, "0.746 to 0.840"}});
}

double SlamLog::errorOfEstimate() const
{
  const std::string label = "PDF estimation: (";
  const auto text = readBytes(file("said"));
  const auto last = text.rfind(label);
  double x = 0, y = 0;
  if (last == std::string::npos) return kFarOff;
  EXPECT_EQ(std::sscanf(text.c_str() + last + label.size(), "%lf,%lf", &x, &y), 2);
  return std::hypot(x - m_last.x(), y - m_last.y());
}

grid::Layer<float> SlamLog::movedToWorld(const grid::Layer<float>& layer) const
{
  EXPECT_EQ(m_first.phi(), 0) << "flat.ini: the start must head along x";
  grid::GridFrame frame = layer.frame();
  frame.x0 += wholeCells(m_first.x(), frame.resolution);
  frame.y0 += wholeCells(m_first.y(), frame.resolution);
  grid::Layer<float> moved(frame, 0);
  moved.cells() = layer.cells();
  return moved;
}

bool isUniform(const std::string& picture)
{
  mrpt::img::CImage image;
  if (!image.loadFromFile(picture)) throw std::runtime_error(picture);
  mrpt::math::CMatrixFloat grey;
  image.getAsMatrix(grey);
  return grey.minCoeff() == grey.maxCoeff();
}

std::string configFile(const std::string& name)
{
  return std::string("'") + MRPT_MAPCONV_SOURCE_DIR + "/config/" + name + "'";
}

std::string withPlugin()
{
  return "env LD_PRELOAD=libmrpt_mapconv.so LD_LIBRARY_PATH=\"$(dirname '" MRPT_MAPCONV_LIBRARY
         "')\" ";
}

}  // namespace mrpt_mapconv::testing
