#include <mrpt_mapconv/files/AtomicFile.h>
#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/sim/SampleMaps.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <octomap/OcTree.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "command/Command.h"
#include "output/Console.h"
#include "output/Progress.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
struct SampleMapOptions
{
  std::string name, file;
  std::optional<double> resolution;
};

std::unique_ptr<octomap::OcTree> generate(const SampleMapOptions& options)
{
  if (options.name == "building")
    return options.resolution ? sim::buildingMap(*options.resolution) : sim::buildingMap();
  sim::OutdoorOptions outdoor;
  if (options.resolution) outdoor.resolution = *options.resolution;
  return sim::outdoorMap(outdoor);
}

int makeSampleMap(const SampleMapOptions& options)
{
  if (std::filesystem::path(options.file).extension() != ".bt")
    throw UsageError("-o " + options.file + ": the name must end in .bt");
  ResultOutput result;
  files::AtomicFile file(options.file);
  std::optional<Progress> progress(std::in_place);
  progress->stage("generating the " + options.name + " map");
  const auto tree = generate(options);
  voxel::writeOctreeFile(file.stagingPath(), *tree, "made by mapconv sample-map");
  file.commit();
  progress.reset();
  result.print(params::printable(options.file) + ": " + std::to_string(tree->getNumLeafNodes()) +
               " leaves\n");
  return 0;
}
}  // namespace

std::pair<CLI::App*, Command> addSampleMap(CLI::App& app)
{
  CLI::App* sub = app.add_subcommand("sample-map", "Writes a generated voxel map to try things on");
  auto options = std::make_shared<SampleMapOptions>();
  sub->add_option("NAME", options->name, "building (12 x 8 m) or outdoor (200 x 200 m)")
      ->required()
      ->check(CLI::IsMember({"building", "outdoor"}))
      ->type_name("");
  sub->add_option("-o,--output", options->file, "the file to write, a .bt of OctoMap")
      ->required()
      ->type_name("FILE.bt");
  sub->add_option("--resolution", options->resolution,
                  "voxel size [m], default 0.05 (building), 0.2 (outdoor)")
      ->type_name("M");
  sub->footer("Example:\n  mapconv sample-map building -o building.bt");
  return {sub, [options] { return makeSampleMap(*options); }};
}

}  // namespace mapconv
