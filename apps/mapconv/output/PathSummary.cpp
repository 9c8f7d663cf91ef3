#include "output/PathSummary.h"

#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mapconv
{
namespace path = mrpt_mapconv::path;
using path::HeightRule;

namespace
{
struct PathFigures
{
  double length = 0, lowest = INFINITY, highest = -INFINITY;
  std::size_t floorAhead = 0, sphere = 0;  // points whose height the rules decided
};

PathFigures figuresOf(const path::LiftedPath& path)
{
  PathFigures figures;
  for (std::size_t i = 0; i < path.points.size(); ++i)
  {
    const path::LiftedPoint& point = path.points[i];
    if (i > 0) figures.length += (point.position - path.points[i - 1].position).norm();
    figures.lowest = std::min(figures.lowest, point.position.z);
    figures.highest = std::max(figures.highest, point.position.z);
    ++(point.rule == HeightRule::FloorAhead ? figures.floorAhead : figures.sphere);
  }
  return figures;
}
}  // namespace

std::string pathCsv(const path::LiftedPath& path)
{
  std::string text = "x,y,z\n";
  for (const auto& point : path.points)
    text += jsonNumber(point.position.x) + "," + jsonNumber(point.position.y) + "," +
            jsonNumber(point.position.z) + "\n";
  return text;
}

std::string pathText(const path::LiftedPath& path)
{
  const PathFigures figures = figuresOf(path);
  std::string text =
      mrpt::format("points       %zu, %.2f m long, z from %.2f to %.2f m\n", path.points.size(),
                   figures.length, figures.lowest, figures.highest);
  text += mrpt::format("heights      %zu from the floor ahead and behind, %zu from the sphere\n",
                       figures.floorAhead, figures.sphere);
  return text;
}

JsonObject pathJson(const path::LiftedPath& path)
{
  const PathFigures figures = figuresOf(path);
  JsonObject json;
  json.add("points", path.points.size()).add("length", figures.length);
  json.add("zMin", figures.lowest).add("zMax", figures.highest);
  json.add("heightsFromFloor", figures.floorAhead).add("heightsFromSphere", figures.sphere);
  return json.add("slabsChecked", path.slabsChecked);
}

}  // namespace mapconv
