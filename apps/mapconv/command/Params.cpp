#include <mrpt_mapconv/aerial/GroundParams.h>
#include <mrpt_mapconv/freespace/ConversionOptions.h>
#include <mrpt_mapconv/freespace/FreeSpaceScene.h>
#include <mrpt_mapconv/maps/GridInsertionOptions.h>
#include <mrpt_mapconv/scan/ScanGridParams.h>
#include <mrpt_mapconv/scan/ScanInsertionOptions.h>
#include <mrpt_mapconv/terrain/TerrainOptions.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>
#include <mrpt_mapconv/voxel/VoxelMapParams.h>

#include <CLI/CLI.hpp>

#include "command/Command.h"
#include "input/FieldFlags.h"
#include "output/Console.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** A table of the fields of a struct that has a list of them.
 * \param where the sections that they are read from
 * \param program the subcommand whose flags the list gives; empty: none */
template <class Params>
std::string tableOf(const std::string& where, const std::string& program)
{
  std::string table = "\n### " + where + "\n\n| key | default | unit | meaning | flag |\n";
  table += "|---|---|---|---|---|\n";
  const Params defaults;
  params::visitFields(
      defaults,
      [&](const char* name, const auto& field, const std::string& unit, const std::string& meaning,
          params::About about = {})
      {
        const std::string value = params::isSet(field) ? params::textOf(field) : "none";
        const bool hasFlag = about.flagType && !program.empty();
        table += std::string("| `") + name + "` | " + value + " | " + unit + " | " + meaning +
                 " | " + (hasFlag ? "`" + flagName(name) + "`" : "") + " |\n";
      });
  if constexpr (params::hasNamedSet<Params>)
    table += std::string("| `") + Params::kNamedSet + "` | false | | " + Params::kNamedSetMeaning +
             "; other keys replace what they name | " +
             (program.empty() ? "" : "`" + flagName(Params::kNamedSet) + "`") + " |\n";
  return table;
}

std::string parametersText()
{
  std::string text =
      "# Parameters\n\n"
      "Printed by `mapconv params`; a test compares this page with it. Sections are those below "
      "the "
      "prefix that an MRPT\nprogram gives, e.g. "
      "`[MappingApplication_freeSpaceGrid_00_insertOpts]`, "
      "and those of `mapconv -c FILE.ini`.\n"
      "\n## freeSpaceGrid and `mapconv convert`\n\n`mapconv project` reads `[voxelInsertion]`, "
      "too.\n";
  text += tableOf<voxel::VoxelMapParams>("`_creationOpts`", "");
  text += tableOf<voxel::TVoxelInsertionOptions>("`_insertOpts`; `[voxelInsertion]`", "");
  text += tableOf<freespace::TConversionOptions>("`_conversionOpts`; `[conversion]`", "convert");
  text += tableOf<freespace::TLayerSceneOptions>("`_renderOpts`", "");
  text += "\n## scanShapeGrid and `mapconv insert`\n";
  text += tableOf<scan::ScanGridParams>("`_creationOpts`; `[map]`", "insert");
  text += tableOf<scan::TScanInsertionOptions>("`_insertOpts`; `[scanInsertion]`", "insert");
  text += tableOf<mrpt::maps::COccupancyGridMap2D::TInsertionOptions>(
      "`_insertOpts`; `[scanInsertion]`: COccupancyGridMap2D's own, for 2D scans", "");
  text += "\n## terrainGrid and `mapconv terrain`\n";
  text += tableOf<terrain::TerrainGridParams>("`_creationOpts`; `[map]`", "terrain");
  text +=
      tableOf<terrain::TTerrainInsertionOptions>("`_insertOpts`; `[terrainInsertion]`", "terrain");
  text += tableOf<terrain::TTerrainOptions>("`_terrainOpts`; `[terrain]`", "terrain");
  text += tableOf<terrain::TTerrainSceneOptions>("`_renderOpts`", "");
  text += "\n## `mapconv ground`\n";
  text += tableOf<aerial::GroundParams>("`[ground]`", "ground");
  text +=
      "\n`_likelihoodOpts` of all are those of COccupancyGridMap2D. `_creationOpts` also have the "
      "flags of all of MRPT's maps:\n`enableSaveAs3DObject`, `enableObservationLikelihood`, "
      "`enableObservationInsertion`. Flags beside those in the tables:\n`--resolution` of "
      "`convert` "
      "and `project`; `--structure MIN MAX` (structureMinZ, structureMaxZ),\n"
      "`--no-reflection-filter` and `--no-2d` of `insert`.\n";
  return text;
}

int printParameters()
{
  ResultOutput().print(parametersText());
  return 0;
}
}  // namespace

std::pair<CLI::App*, Command> addParams(CLI::App& app)
{
  CLI::App* sub = app.add_subcommand(
      "params", "Prints tables of all parameters: keys, defaults, units, meanings, flags");
  sub->footer("Example:\n  mapconv params > parameters.md");
  return {sub, printParameters};
}

}  // namespace mapconv
