#include "output/TerrainReport.h"

#include <mrpt/core/format.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt_mapconv/files/ObjectWriter.h>
#include <mrpt_mapconv/grid/LayerScene.h>
#include <mrpt_mapconv/terrain/TerrainScene.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "output/Scene.h"

namespace mapconv
{
using namespace mrpt_mapconv;

TerrainCounts countsOf(const terrain::TerrainMap& map, const terrain::TerrainLayers& layers)
{
  TerrainCounts counts;
  counts.cells = map.cells();
  counts.leaves = map.leaves();
  counts.planes = map.planes().size();
  for (const auto& plane : map.planes())
    counts.cellsInPlanes += static_cast<std::size_t>(plane.cells);
  long smallest = std::numeric_limits<long>::max(), largest = 0;  // in cells: floats are not exact
  for (const float side : layers.leafSide.cells())
    if (std::isfinite(side))
    {
      const long cells = std::lround(static_cast<double>(side) / map.resolution());
      smallest = std::min(smallest, cells);
      largest = std::max(largest, cells);
    }
  counts.smallestLeaf = static_cast<double>(smallest) * map.resolution();
  counts.largestLeaf = static_cast<double>(largest) * map.resolution();
  const auto steps = map.steps();
  counts.steps = steps.size();
  for (const auto& step : steps)
  {
    counts.lowestStep =
        counts.lowestStep > 0 ? std::min(counts.lowestStep, step.height) : step.height;
    counts.highestStep = std::max(counts.highestStep, step.height);
  }
  return counts;
}

std::string countsText(const TerrainCounts& counts)
{
  const auto percent = [&counts](std::size_t part)
  { return 100 * static_cast<double>(part) / static_cast<double>(counts.cells); };
  std::string text = mrpt::format(
      "leaves       %zu of %zu known cells (%.1f %%), sides %.4g to %.4g m\n", counts.leaves,
      counts.cells, percent(counts.leaves), counts.smallestLeaf, counts.largestLeaf);
  text += mrpt::format("planes       %zu with %zu cells (%.1f %%)\n", counts.planes,
                       counts.cellsInPlanes, percent(counts.cellsInPlanes));
  text += mrpt::format("steps        %zu", counts.steps);
  if (counts.steps > 0)
    text += mrpt::format(", %.3f to %.3f m high", counts.lowestStep, counts.highestStep);
  return text + "\n";
}

void addCounts(const TerrainCounts& counts, JsonObject& json)
{
  json.add("knownCells", counts.cells).add("leaves", counts.leaves).add("planes", counts.planes);
  json.add("cellsInPlanes", counts.cellsInPlanes).add("steps", counts.steps);
  json.add("smallestLeaf", counts.smallestLeaf).add("largestLeaf", counts.largestLeaf);
}

void writeTerrainScene(const std::string& path, const terrain::TerrainMap& map,
                       const terrain::TerrainLayers& layers)
{
  auto objects = mrpt::opengl::CSetOfObjects::Create();
  terrain::drawLeaves(map, layers.plane, {}, *objects);
  auto scene = sceneWith(objects, layers.height.frame(), grid::heightBelow(layers.height));
  terrain::drawLegend(map, *scene.getViewport());
  files::writeObject(path, scene);
}

}  // namespace mapconv
