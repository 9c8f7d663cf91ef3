#include <mrpt/core/format.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/maps/OctoMapAccess.h>
#include <mrpt_mapconv/maps/SelfDescription.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <variant>

#include "output/InfoOctree.h"
#include "output/InfoReport.h"

namespace mapconv
{
namespace
{
using mrpt::maps::COccupancyGridMap2D;
using mrpt::obs::CObservation;
using mrpt::serialization::CSerializable;

std::string className(const CSerializable& object) { return object.GetRuntimeClass()->className; }

/** Counts what a rawlog or simplemap holds. */
class LogCensus
{
 public:
  /** False for an object that is no entry of a log. */
  bool add(const CSerializable& object)
  {
    if (const auto* obs = dynamic_cast<const CObservation*>(&object))
      addObservation(*obs);
    else if (const auto* frame = dynamic_cast<const mrpt::obs::CSensoryFrame*>(&object))
      for (const auto& inside : *frame) addPointer(inside);
    else if (dynamic_cast<const mrpt::obs::CActionCollection*>(&object))
      ++m_actions;
    else if (const auto* log = dynamic_cast<const mrpt::obs::CRawlog*>(&object))
      for (std::size_t i = 0; i < log->size(); ++i) addPointer(log->getAsGeneric(i));
    else if (const auto* map = dynamic_cast<const mrpt::maps::CSimpleMap*>(&object))
      addSimpleMap(*map);
    else
      return false;
    return true;
  }

  bool empty() const { return m_classes.empty() && m_actions == 0 && m_keyframes == 0; }
  bool isSimpleMap() const { return m_keyframes > 0; }
  void report(InfoReport& report) const;

 private:
  struct ClassCount
  {
    std::size_t count = 0;
    std::set<std::string> labels;
  };

  template <class Pointer>
  void addPointer(const Pointer& object)
  {
    if (object) add(*object);
  }

  void addSimpleMap(const mrpt::maps::CSimpleMap& map)
  {
    for (const auto& [pose, frame] : map)
    {
      ++m_keyframes;
      addPointer(frame);
    }
  }

  void addObservation(const CObservation& obs)
  {
    auto& entry = m_classes[className(obs)];
    ++entry.count;
    entry.labels.insert(obs.sensorLabel);
    if (mrpt_mapconv::observation::is3DScan(obs)) ++m_scans3D;
    if (dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&obs)) ++m_robotPoses;
    if (dynamic_cast<const mrpt::obs::CObservationOdometry*>(&obs)) ++m_odometry;
    if (obs.timestamp == INVALID_TIMESTAMP) return;
    const double time = mrpt::Clock::toDouble(obs.timestamp);
    m_first = std::min(m_first.value_or(time), time);
    m_last = std::max(m_last.value_or(time), time);
  }

  std::string posesFrom() const
  {
    if (m_keyframes > 0) return "keyframes";
    if (m_robotPoses > 0) return "CObservationRobotPose";
    if (m_odometry > 0) return "CObservationOdometry";
    return m_actions > 0 ? "CActionCollection" : "none";
  }

  std::map<std::string, ClassCount> m_classes;
  std::size_t m_keyframes = 0, m_actions = 0, m_scans3D = 0, m_robotPoses = 0, m_odometry = 0;
  std::optional<double> m_first, m_last;  //!< of the observations' stamps [s]
};

void LogCensus::report(InfoReport& report) const
{
  JsonObject classes;
  std::set<std::string> labels;
  for (const auto& [name, entry] : m_classes)
  {
    std::string text = std::to_string(entry.count);
    for (const auto& label : entry.labels)
      text += label.empty() ? ", without label" : ", label '" + label + "'";
    report.line(name, text);
    classes.add(name, entry.count);
    labels.insert(entry.labels.begin(), entry.labels.end());
  }
  const double duration = m_first ? *m_last - *m_first : 0;
  if (m_keyframes > 0) report.line("keyframes", std::to_string(m_keyframes));
  if (m_actions > 0) report.line("actions", std::to_string(m_actions));
  report.line("3D scans", std::to_string(m_scans3D));
  report.line("duration", mrpt::format("%.3f s", duration));
  report.line("poses", posesFrom() == "none" ? "none" : "from " + posesFrom());
  report.json.add("observations", classes);
  report.json.add("labels", std::vector<std::string>(labels.begin(), labels.end()));
  report.json.add("keyframes", m_keyframes).add("actions", m_actions);
  report.json.add("scans3D", m_scans3D).add("durationSeconds", duration).add("poses", posesFrom());
}

void describeGrid(const COccupancyGridMap2D& grid, InfoReport& report)
{
  std::size_t free = 0, occupied = 0, unknown = 0;
  for (unsigned y = 0; y < grid.getSizeY(); ++y)
    for (unsigned x = 0; x < grid.getSizeX(); ++x)
    {
      const auto raw = grid.getRow(static_cast<int>(y))[x];  // log-odds of free
      ++(raw > 0 ? free : raw < 0 ? occupied : unknown);
    }
  const auto resolution = static_cast<double>(grid.getResolution());
  const auto limits = [](float a, float b) { return mrpt::format("%.2f to %.2f", a, b); };
  report.line("resolution", mrpt::format("%.6g m", resolution));
  report.line("size", mrpt::format("%u x %u cells", grid.getSizeX(), grid.getSizeY()));
  report.line("limits", "x " + limits(grid.getXMin(), grid.getXMax()) + ", y " +
                            limits(grid.getYMin(), grid.getYMax()) + " m");
  report.line("cells",
              mrpt::format("%zu free, %zu occupied, %zu unknown", free, occupied, unknown));
  report.json.add("resolution", resolution);
  report.json.add("width", grid.getSizeX()).add("height", grid.getSizeY());
  report.json.add("xMin", grid.getXMin()).add("xMax", grid.getXMax());
  report.json.add("yMin", grid.getYMin()).add("yMax", grid.getYMax());
  report.json.add("free", free).add("occupied", occupied).add("unknown", unknown);
}

void describeItself(const mrpt_mapconv::maps::SelfDescribing& map, InfoReport& report)
{
  const auto description = map.describe();
  for (const auto& [label, text] : description.lines) report.line(label, text);
  JsonObject values;
  for (const auto& [key, value] : description.values)
    std::visit([&values, name = key](const auto& v) { values.add(name, v); }, value);
  report.json.add(description.name, values);
}

void describeObject(const CSerializable& object, InfoReport& report)
{
  report.json.add("kind", className(object));
  report.line("kind", className(object));
  if (const auto* tree = mrpt_mapconv::maps::octreeIn(object))
    describeOctree(*tree, report);
  else if (const auto* grid = dynamic_cast<const COccupancyGridMap2D*>(&object))
  {
    describeGrid(*grid, report);
    if (const auto* ours = dynamic_cast<const mrpt_mapconv::maps::SelfDescribing*>(&object))
      describeItself(*ours, report);
  }
}

void describeLog(const LogCensus& census, InfoReport& report)
{
  report.json.add("kind", census.isSimpleMap() ? "simplemap" : "rawlog");
  report.line("kind", census.isSimpleMap() ? "MRPT simplemap" : "MRPT rawlog");
  census.report(report);
}
}  // namespace

void describeObjectFile(mrpt_mapconv::files::InputStream stream, InfoReport& report)
{
  mrpt_mapconv::files::ObjectFile file(std::move(stream));
  LogCensus census;
  CSerializable::Ptr first;  // of those that are no entries of a log
  std::size_t others = 0;
  while (const auto object = file.next())
    if (!census.add(*object) && ++others == 1) first = object;

  if (!census.empty())
    describeLog(census, report);
  else if (first)
    describeObject(*first, report);
  else
    throw std::runtime_error(file.path() + ": holds no object");
  const std::size_t undescribed = census.empty() ? others - 1 : others;
  if (undescribed > 0) report.line("others", std::to_string(undescribed) + " more objects");
}

}  // namespace mapconv
