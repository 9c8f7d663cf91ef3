#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/params/IniText.h>
#include <mrpt_mapconv/sim/Scenario.h>
#include <mrpt_mapconv/sim/SimulationFiles.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/TempDir.h"

// The example that users copy from holds everything that there is, and so does its document.
namespace
{
using namespace mrpt_mapconv;
using mrpt_mapconv::testing::contains;
using mrpt_mapconv::testing::readBytes;
using mrpt_mapconv::testing::TempDir;

const std::string kExample = MRPT_MAPCONV_SOURCE_DIR "/config/worlds/example.ini";
const std::string kDocument = MRPT_MAPCONV_SOURCE_DIR "/share/doc/worlds.md";

/** The kinds of its bodies, and of its sensors. */
struct Kinds
{
  std::set<std::string> bodies, sensors;
};

Kinds kindsIn(const std::string& file)
{
  const mrpt::config::CConfigFileMemory ini(params::readIniText(file));
  std::vector<std::string> sections;
  ini.getAllSections(sections);
  Kinds kinds;
  for (const auto& section : sections)
  {
    const std::string kind = section.substr(0, section.find('.'));
    if (kind == "sensor")
      kinds.sensors.insert(ini.read_string(section, "kind", ""));
    else if (sim::PrimitiveKind::find(kind))
      kinds.bodies.insert(kind);
  }
  return kinds;
}

std::set<std::string> setOf(const std::vector<std::string>& names)
{
  return {names.begin(), names.end()};
}

TEST(ExampleWorld, HoldsEveryKindOfBodyAndSensor)
{
  const Kinds kinds = kindsIn(kExample);
  EXPECT_EQ(kinds.bodies, setOf(sim::PrimitiveKind::names()));
  EXPECT_EQ(kinds.sensors, setOf(sim::sensorKinds()));
  const std::string text = readBytes(kExample);
  EXPECT_TRUE(std::all_of(text.begin(), text.end(),
                          [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }))
      << "it should be plain ASCII";
}

TEST(ExampleWorld, ItsDocumentNamesEveryKindAndKey)
{
  const std::string document = readBytes(kDocument);
  for (const auto& kind : sim::PrimitiveKind::names())
    EXPECT_TRUE(contains(document, "### [" + kind + ".NAME]")) << kind;
  for (const auto& kind : sim::sensorKinds())
    EXPECT_TRUE(contains(document, "`kind = " + kind + "`")) << kind;
  const mrpt::config::CConfigFileMemory ini(params::readIniText(kExample));
  std::vector<std::string> sections, keys;
  ini.getAllSections(sections);
  for (const auto& section : sections)
  {
    ini.getAllKeys(section, keys);
    for (const auto& key : keys) EXPECT_TRUE(contains(document, "`" + key + "`")) << key;
  }
}

TEST(ExampleWorld, IsSimulated)
{
  const auto scenario = sim::Scenario::load(kExample);
  const TempDir dir;
  files::OutputDir out(dir.path("out"));
  const auto summary = sim::simulateTo(out, scenario, 1);
  out.commit();
  EXPECT_GT(summary.returns3D, 50000u);
  const auto at = [&](const std::string& band, double x, double y)
  {
    const auto layer = grid::readGeoTiffBand(dir.path("out/truth.tif"), band);
    const auto key = [&](double v)
    { return static_cast<std::int32_t>(std::floor(v / layer.frame().resolution)); };
    return layer.cells()[layer.frame().indexOfKey(key(x), key(y))];
  };
  // what the comments of the file promise
  EXPECT_EQ(at("ground", 6.05, 4.05), 0) << "ramp";
  EXPECT_FLOAT_EQ(at("slope", 6.05, 4.05), 0.2f);
  EXPECT_EQ(at("ground", 5.95, 5.05), 1) << "a step of the stairs";
  EXPECT_FLOAT_EQ(at("floor", 7.55, 5.05), 0.4f) << "platform";
  EXPECT_EQ(at("ground", 2.05, 1.05), 1) << "ball";
  EXPECT_FLOAT_EQ(at("floor", 2.05, 2.45), 0) << "the way";
  EXPECT_GT(at("inView", 3.75, 0.05), 0) << "the wall behind the glass";
}
}  // namespace
