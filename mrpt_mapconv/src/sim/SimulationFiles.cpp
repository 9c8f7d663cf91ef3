#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/files/ObjectStream.h>
#include <mrpt_mapconv/grid/LayerExport.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/sim/SimulationFiles.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace mrpt_mapconv::sim
{
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CSensoryFrame;
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

namespace
{
/** Never "-0". */
std::string coordinateText(double value) { return params::shortestText(value + 0.0); }

constexpr double kTruthShare = 0.1;  //!< of the progress

/** The poses over time, as lines of text. */
class TrajectoryFile
{
 public:
  explicit TrajectoryFile(const std::string& path) : m_path(path)
  {
    files::writeFile(path, {});
    m_file.open(path, std::ios::binary | std::ios::trunc);
    m_file << "t,x,y,z,yaw,pitch,roll\n";
  }

  void write(double seconds, const CPose3D& pose)
  {
    std::string line = coordinateText(seconds);
    for (const double v : {pose.x(), pose.y(), pose.z(), pose.yaw(), pose.pitch(), pose.roll()})
      line += "," + coordinateText(v);
    m_file << line << '\n';
  }

  void finish()
  {
    m_file.close();
    if (!m_file) files::throwUnwritten(m_path, "it is incomplete");
    files::checkWritten(m_path);
  }

 private:
  std::string m_path;
  std::ofstream m_file;
};

CSensoryFrame frameOf(const Moment& moment)
{
  CSensoryFrame frame;
  for (const Scan& scan : moment.scans) frame.insert(scan.observation);
  return frame;
}

mrpt::poses::CPose3DPDFGaussian estimateOf(const Moment& moment, const NoiseParams& noise)
{
  // MRPT inverts covariances: even a perfect estimate has to have one.
  const auto metres = [](double sigma) { return std::max(sigma, 1e-3); };
  const auto angle = [](double degrees) { return mrpt::DEG2RAD(std::max(degrees, 0.01)); };
  const double xy = metres(noise.posePosition), tilt = angle(noise.posePitchRoll());
  const double sigmas[] = {xy,   xy,  metres(noise.poseZ()), angle(noise.poseAngle),
                           tilt, tilt};  // yaw, pitch, roll
  mrpt::poses::CPose3DPDFGaussian estimate(moment.estimatedPose);
  estimate.cov.setZero();
  for (int i = 0; i < 6; ++i) estimate.cov(i, i) = mrpt::square(sigmas[i]);
  return estimate;
}

/** A Gaussian about a step of odometry as wide as its noise and drift, but at least 1 mm and 0.02
 * degrees: particle filters need some. */
CActionRobotMovement2D::TMotionModelOptions motionModel(const CPose2D& step,
                                                        const NoiseParams& noise)
{
  const auto spread = odometrySpread(step, noise);
  const double drift = mrpt::DEG2RAD(noise.odometryDrift * step.norm());
  CActionRobotMovement2D::TMotionModelOptions options;
  options.modelSelection = CActionRobotMovement2D::mmGaussian;
  options.gaussianModel = {0,
                           0,
                           0,
                           0,
                           std::max(spread.position, 0.001),
                           std::max(std::hypot(spread.yaw, drift), mrpt::DEG2RAD(0.02))};
  return options;
}

/** Everything that is written while the robot moves. */
class Recorder
{
 public:
  Recorder(files::OutputDir& out, const Scenario& scenario, std::uint32_t keyFrames)
      : m_scenario(scenario),
        m_observations(out.path("scans.rawlog")),
        m_frames(out.path("frames.rawlog")),
        m_map(out.path("scans.simplemap"), keyFrames),
        m_trajectory(out.path("trajectory.csv"))
  {
  }

  void write(const Moment& moment)
  {
    writeObservations(moment);
    const CSensoryFrame frame = frameOf(moment);
    m_frames.write(actionTo(moment));
    m_frames.write(frame);
    if (moment.keyFrame) m_map.write(estimateOf(moment, m_scenario.noise), frame);
    m_trajectory.write(moment.seconds, moment.pose);
  }

  void finish()
  {
    m_observations.finish();
    m_frames.finish();
    m_map.finish();
    m_trajectory.finish();
  }

 private:
  void writeObservations(const Moment& moment)
  {
    mrpt::obs::CObservationOdometry odometry;
    odometry.timestamp = moment.time;
    odometry.sensorLabel = "odometry";
    odometry.odometry = moment.odometry;
    m_observations.write(odometry);
    if (m_scenario.log.poses)
    {
      mrpt::obs::CObservationRobotPose pose;
      pose.timestamp = moment.time;
      pose.sensorLabel = "pose";
      pose.pose = estimateOf(moment, m_scenario.noise);
      m_observations.write(pose);
    }
    for (const Scan& scan : moment.scans) m_observations.write(*scan.observation);
  }

  mrpt::obs::CActionCollection actionTo(const Moment& moment)
  {
    const CPose2D step = m_isFirst ? CPose2D() : moment.odometry - m_lastOdometry;
    m_isFirst = false;
    m_lastOdometry = moment.odometry;
    CActionRobotMovement2D movement;
    movement.timestamp = moment.time;
    movement.computeFromOdometry(step, motionModel(step, m_scenario.noise));
    mrpt::obs::CActionCollection actions;
    actions.insert(movement);
    return actions;
  }

  const Scenario& m_scenario;
  files::ObjectStream m_observations, m_frames;
  files::SimpleMapStream m_map;
  TrajectoryFile m_trajectory;
  bool m_isFirst = true;
  CPose2D m_lastOdometry;
};

std::uint32_t countKeyFrames(const Scenario& scenario)
{
  Schedule schedule(scenario);
  std::uint64_t count = 0;
  while (const auto slot = schedule.next()) count += slot->keyFrame ? 1 : 0;
  if (count > std::numeric_limits<std::uint32_t>::max())
    throw std::runtime_error("a simplemap cannot hold " + std::to_string(count) + " key frames");
  return static_cast<std::uint32_t>(count);
}

void addTo(SimulationSummary& summary, const Moment& moment)
{
  summary.seconds = moment.seconds;
  ++summary.moments;
  summary.scans += moment.scans.size();
  summary.keyFrames += moment.keyFrame ? 1 : 0;
  for (const Scan& scan : moment.scans)
    if (scan.is3D) summary.returns3D += scan.truePoints.size();
}

double wayOf(const Trajectory& trajectory)
{
  double way = 0;
  const auto& knots = trajectory.knots();
  for (std::size_t i = 1; i < knots.size(); ++i)
    way += knots[i].position.distanceTo(knots[i - 1].position);
  return way;
}

/** A world has gaps where a voxel map has free ranges. */
std::string truthTitle(const grid::StyledLayer& layer)
{
  if (layer.name == "floor") return "Truth: bottom of the lowest gap";
  if (layer.name == "ceiling") return "Truth: top of the highest gap";
  std::string title = layer.title;
  title.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(title.front())));
  return "Truth: " + title;
}

/** Logarithms: cells beside the way got a thousand times more than those far from it. */
grid::Layer<float> logarithmOf(grid::Layer<float> counts)
{
  for (float& count : counts.cells())
    count = count > 0 ? std::log10(count) : freespace::Layers::kNone;
  return counts;
}

/** The truth has no evidence: all is known. */
std::vector<grid::StyledLayer> truthBands(const freespace::Layers& layers)
{
  std::vector<grid::StyledLayer> bands;
  for (const auto& entry : freespace::Layers::list())
    if (!entry.isOfGround())
    {
      bands.push_back(layers.styled(entry.name));
      bands.back().evidence = nullptr;
    }
  return bands;
}

void writeTruth(files::OutputDir& out, const Scenario& scenario, const grid::Layer<float>& inView)
{
  const auto layers = truthLayers(scenario.world, inView.frame(), scenario.truth);
  auto bands = truthBands(layers);
  bands.push_back({"inView", &inView});
  grid::exportLayers(out, bands, {"truth.tif"});

  const auto seen = logarithmOf(inView);
  auto pictures = truthBands(layers);
  for (grid::StyledLayer& layer : pictures)
  {
    layer.title = truthTitle(layer);
    layer.freeFor = nullptr;  // its legend would blame steps for what has no headroom
  }
  pictures.push_back({"inView", &seen, "In view: 3D returns per cell (log10)", "log10(returns)"});
  grid::ExportFormats formats;
  formats.prefix = "truth_";
  formats.pictures = true;
  grid::exportLayers(out, pictures, formats);
}
}  // namespace

void countReturns(const Moment& moment, grid::Layer<float>& inView)
{
  const grid::GridFrame& frame = inView.frame();
  const auto key = [&](float metres)
  { return static_cast<std::int32_t>(std::floor(static_cast<double>(metres) / frame.resolution)); };
  for (const Scan& scan : moment.scans)
  {
    if (!scan.is3D) continue;
    for (const auto& point : scan.truePoints)
      if (frame.containsKey(key(point.x), key(point.y)))
        inView.cells()[frame.indexOfKey(key(point.x), key(point.y))] += 1;
  }
}

SimulationSummary simulateTo(files::OutputDir& out, const Scenario& scenario, std::uint64_t seed,
                             const std::function<void(double)>& progress)
{
  const auto report = [&](double share)
  {
    if (progress) progress(share);
  };
  SimulationSummary summary;
  summary.way = wayOf(scenario.trajectory);
  grid::Layer<float> inView(frameOf(scenario.world, scenario.truthResolution), 0.0f);
  Recorder recorder(out, scenario, countKeyFrames(scenario));
  Simulator simulator(scenario, seed);
  while (const auto moment = simulator.next())
  {
    recorder.write(*moment);
    countReturns(*moment, inView);
    addTo(summary, *moment);
    report((1 - kTruthShare) * moment->seconds / scenario.trajectory.duration());
  }
  recorder.finish();
  writeTruth(out, scenario, inView);
  report(1);
  return summary;
}

}  // namespace mrpt_mapconv::sim
