#include "experiment/terrain/TerrainReport.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
std::string megabytes(std::size_t bytes) { return fixed(1e-6 * static_cast<double>(bytes), 2); }

void addPlaneRow(const std::string& world, double resolution, const std::string& rule,
                 const AdaptiveMap& map, Table& table)
{
  const eval::Agreement& match = map.match;
  table.addRow({world, metres(resolution), rule, std::to_string(match.found + match.missed),
                percent(match.recall()), std::to_string(map.planes),
                std::to_string(match.right + match.wrong), percent(match.precision())});
}
}  // namespace

void addSizes(const TerrainResults& results, Report& report)
{
  Table table{"sizes",
              "Leaves, memory and queries beside a flat grid",
              {"world", "L [m]", "cells", "leaves (fused)", "cells per leaf", "leaves (maximum)",
               "memory [MB] (fused)", "elevation map: cells", "elevation map: memory [MB]",
               "query of leaves [ns]", "query of a flat grid [ns]"},
              {}};
  for (const TerrainWorldResult& result : results)
    for (const TerrainRun& run : result.runs)
      table.addRow(
          {result.world.name, metres(run.resolution), std::to_string(run.fused.cells),
           std::to_string(run.fused.leaves),
           fixed(static_cast<double>(run.fused.cells) / static_cast<double>(run.fused.leaves), 1),
           std::to_string(run.maximum.leaves), megabytes(run.fused.memory),
           std::to_string(run.elevationCells), megabytes(run.elevationMemory),
           fixed(run.queries.leaves, 0), fixed(run.queries.cells, 0)});
  table.note =
      "Our memory is that of cells with all they know of their points, planes and leaves; the "
      "elevation map's that of its dense grid and of the fused one. A query of leaves gives "
      "height, normal and plane at a random place, one of the flat grid its cell's height.";
  report.addHeading("Leaves, memory and queries");
  report.addTable(table);
}

void addPlanes(const TerrainResults& results, const TerrainExperimentSettings& settings,
               Report& report)
{
  Table table{"planes",
              "Planes against true ones",
              {"world", "L [m]", "rule", "true planes", "recall", "planes of the map",
               "of them judged", "precision"},
              {}};
  for (const TerrainWorldResult& result : results)
    for (const TerrainRun& run : result.runs)
    {
      addPlaneRow(result.world.name, run.resolution, "fused", run.fused, table);
      addPlaneRow(result.world.name, run.resolution, "maximum", run.maximum, table);
    }
  table.note = "A plane is right if it and a true one share " + percent(settings.overlap) +
               " of the cells of either (Hoover et al. 1996), of cells with a true plane that the "
               "map knows. True planes and those of the map count from " +
               std::to_string(settings.params.minPlaneCells) + " such cells on.";
  report.addHeading("Planes");
  report.addTable(table);
}

}  // namespace mapconv
