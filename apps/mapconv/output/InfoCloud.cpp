#include <mrpt/core/format.h>
#include <mrpt_mapconv/cloud/CloudFields.h>
#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "output/InfoReport.h"

namespace mapconv
{
namespace
{
using namespace mrpt_mapconv;
using cloud::Field;
using cloud::PointCloud;

constexpr Field kFirstAttribute = Field::Time;

bool isInDegrees(const PointCloud& cloud)
{
  return cloud.namedUnits && cloud.namedUnits->kind == grid::SystemKind::Geographic;
}

std::string unitOf(const PointCloud& cloud, Field axis)
{
  if (axis == Field::Z) return grid::unitInWords(cloud.heightUnit);
  return isInDegrees(cloud) ? "degrees" : grid::unitInWords(cloud.unit);
}

void describeExtent(const PointCloud& cloud, InfoReport& report)
{
  for (const Field axis : {Field::X, Field::Y, Field::Z})
    if (const auto range = rangeOf(cloud, axis))
    {
      const std::string name(1, "xyz"[indexOf(axis)]);
      report.line(name, mrpt::format("%.3f to %.3f (%.3f %s)", range->min, range->max,
                                     range->max - range->min, unitOf(cloud, axis).c_str()));
      report.json.add(name + "Min", range->min).add(name + "Max", range->max);
    }
}

std::string rangeText(const PointCloud& cloud, Field field)
{
  const auto range = rangeOf(cloud, field);
  return range ? jsonNumber(range->min) + " to " + jsonNumber(range->max) : "";
}

/** For people and for JSON. */
struct EpochWords
{
  const char *text, *key;
};
EpochWords wordsOf(cloud::TimeEpoch epoch)
{
  switch (epoch)
  {
    case cloud::TimeEpoch::GpsWeek:
      return {" s of the GPS week", "gpsWeek"};
    case cloud::TimeEpoch::AdjustedGps:
      return {" s, adjusted standard GPS time (GPS seconds less 1e9)", "adjustedGps"};
    case cloud::TimeEpoch::Unknown:
      break;
  }
  return {" s", ""};
}

/** All that points have beside coordinates. */
void describeFields(const PointCloud& cloud, InfoReport& report)
{
  JsonObject fields;
  visitFields(cloud,
              [&](Field field, const char* name, const auto&)
              {
                const auto range = field < kFirstAttribute ? std::nullopt : rangeOf(cloud, field);
                if (range)
                  fields.add(name, JsonObject().add("min", range->min).add("max", range->max));
              });
  const EpochWords epoch = wordsOf(cloud.timeEpoch);
  report.json.add("fields", fields).add("timeEpoch", epoch.key);
  report.json.add("otherFields", cloud.otherFields);

  const auto line = [&](const char* label, Field field, const char* what = "")
  {
    const std::string text = rangeText(cloud, field);
    if (!text.empty()) report.line(label, text + what);
  };
  line("time", Field::Time, epoch.text);
  line("intensity", Field::Intensity);
  line("return", Field::ReturnNumber);
  line("returns", Field::NumberOfReturns);
  std::string others;
  for (const auto& name : cloud.otherFields) others += (others.empty() ? "" : ", ") + name;
  if (!others.empty()) report.line("not read", others);
}

std::string withName(int itsClass)
{
  static const std::map<int, const char*> names = {
      {0, "never classified"}, {1, "unclassified"},      {2, "ground"},
      {3, "low vegetation"},   {4, "medium vegetation"}, {5, "high vegetation"},
      {6, "building"},         {7, "low noise"},         {9, "water"},
      {17, "bridge deck"},     {18, "high noise"}};
  const auto name = names.find(itsClass);
  return std::to_string(itsClass) + (name == names.end() ? "" : std::string(" ") + name->second);
}

void describeClasses(const PointCloud& cloud, InfoReport& report)
{
  std::map<int, std::size_t> counts;
  for (const auto itsClass : cloud.classification) ++counts[itsClass];
  JsonObject classes;
  std::string text;
  for (const auto& [itsClass, count] : counts)
  {
    text += (text.empty() ? "" : ", ") + withName(itsClass) + ": " + std::to_string(count);
    classes.add(std::to_string(itsClass), count);
  }
  if (!text.empty()) report.line("classes", text);
  report.json.add("classes", classes);
}

void describeUnits(const PointCloud& cloud, InfoReport& report)
{
  std::string text = unitOf(cloud, Field::X);
  if (const auto heights = unitOf(cloud, Field::Z); heights != text)
    text += ", heights in " + heights;
  report.line("units", text + (cloud.namedUnits ? "" : ", assumed: the file names none"));
  report.json.add("metresPerUnit", isInDegrees(cloud) ? NAN : cloud.unit);
  report.json.add("metresPerHeightUnit", cloud.heightUnit);
}
}  // namespace

void describeCloudFile(files::InputStream& stream, const std::string& columns, InfoReport& report)
{
  const PointCloud cloud = mrpt_mapconv::cloud::readCloud(stream, {{}, columns});
  const auto withheld = static_cast<std::size_t>(
      std::count_if(cloud.withheld.begin(), cloud.withheld.end(), [](auto w) { return w != 0; }));
  report.json.add("kind", "cloud").add("format", cloud.format).add("points", cloud.size());
  report.line("kind", "cloud of points");
  report.line("format", cloud.format);
  report.line("points", std::to_string(cloud.size()));
  describeExtent(cloud, report);
  describeFields(cloud, report);
  describeClasses(cloud, report);
  if (!cloud.withheld.empty()) report.line("withheld", params::counted(withheld, "point"));
  if (cloud.notFinite > 0)
    report.line("left out", params::counted(cloud.notFinite, "point") +
                                ", of which a coordinate is NaN or infinite");
  report.line("system",
              cloud.coordinateSystem.empty() ? "the file names none" : cloud.coordinateSystem);
  describeUnits(cloud, report);
  report.json.add("withheld", withheld).add("notFinite", cloud.notFinite);
  report.json.add("coordinateSystem", cloud.coordinateSystem);
}

}  // namespace mapconv
