#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <unistd.h>

#include <filesystem>

#include "experiment/freespace/FreespaceResult.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** Bytes of a file that `write` makes, in a folder of its own that is removed afterwards. */
template <class Write>
double fileBytes(const std::string& name, const Write& write)
{
  const auto dir =
      std::filesystem::temp_directory_path() / ("mapconv-sizes-" + std::to_string(::getpid()));
  files::OutputDir out(dir.string());
  const std::string path = out.path(name);
  write(path);
  return static_cast<double>(std::filesystem::file_size(path));
}

struct Sizes
{
  std::string what;
  double map, withFloor, withBoth;  // bytes
};

std::string megabytes(double bytes) { return fixed(bytes / 1e6, 2) + " MB"; }

std::vector<Sizes> sizesOf(const freespace::Layers& layers)
{
  const auto cells = static_cast<double>(layers.frame().size());
  const double map =
      fileBytes("a.gridmap", [&](const auto& f) { grid::writeGridMap(f, layers.aerial); });
  const double floor = fileBytes("a.tif",
                                 [&](const auto& f) {
                                   grid::writeGeoTiff(f, {{"floor", &layers.floor}});
                                 });
  const double both =
      fileBytes("a.tif",
                [&](const auto& f) {
                  grid::writeGeoTiff(f, {{"floor", &layers.floor}, {"ceiling", &layers.ceiling}});
                });
  return {{"raw (1 byte a cell, float32 heights)", cells, 5 * cells, 9 * cells},
          {"our files (.gridmap, GeoTIFF)", map, map + floor, map + both}};
}

struct OctreeSizes
{
  double memory, ot, bt;
};

OctreeSizes octreeSizes(const octomap::OcTree& tree)
{
  const double bt = fileBytes("a.bt", [&](const auto& f) { voxel::writeOctreeFile(f, tree); });
  return {static_cast<double>(tree.memoryUsage()),
          static_cast<double>(voxel::fullOctree(tree).size()), bt};
}

std::string shares(const Sizes& sizes, double whole)
{
  return percent(sizes.map / whole) + " / " + percent(sizes.withFloor / whole) + " / " +
         percent(sizes.withBoth / whole);
}

std::string paperShares(const std::vector<double>& sizes)
{
  return fixed(sizes[0], 1) + " % / " + fixed(sizes[1], 1) + " % / " + fixed(sizes[2], 1) + " %";
}
}  // namespace

void addSizes(const Results& results, Report& report)
{
  Table table{
      "table3_sizes",
      "Table III: sizes of 2D map / + floor / + floor and ceiling",
      {"world", "what", "size", "% of the octree in memory", "% of .ot", "% of .bt", "paper"},
      {}};
  for (const FreespaceResult& result : results)
  {
    const OctreeSizes tree = octreeSizes(*result.run.tree);
    table.addRow({result.world.name, "octree",
                  megabytes(tree.memory) + " in memory, " + megabytes(tree.ot) + " .ot, " +
                      megabytes(tree.bt) + " .bt",
                  "100 %", percent(tree.ot / tree.memory) + " (its size)",
                  percent(tree.bt / tree.memory) + " (its size)", ""});
    for (const Sizes& sizes : sizesOf(result.maps.layers))
      table.addRow({result.world.name, sizes.what,
                    megabytes(sizes.map) + " / " + megabytes(sizes.withFloor) + " / " +
                        megabytes(sizes.withBoth),
                    shares(sizes, tree.memory), shares(sizes, tree.ot), shares(sizes, tree.bt),
                    paperShares(result.world.paper->sizes)});
  }
  table.note =
      "The paper does not say in which form it took the octree; a 2D map's share depends on how "
      "much of its bounding box is known, and how often a column is high.";
  report.addHeading("Sizes");
  report.addTable(table);
}

}  // namespace mapconv
