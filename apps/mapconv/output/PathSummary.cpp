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
  double lowest = INFINITY, highest = -INFINITY;
  std::size_t floorAhead = 0, sphere = 0;  // points whose height the rules decided
};

PathFigures figuresOf(const path::LiftedPath& path)
{
  PathFigures figures;
  for (const path::LiftedPoint& point : path.points)
  {
    figures.lowest = std::min(figures.lowest, point.position.z);
    figures.highest = std::max(figures.highest, point.position.z);
    ++(point.rule == HeightRule::FloorAhead ? figures.floorAhead : figures.sphere);
  }
  figures.lowest += path.shownOrigin.z;
  figures.highest += path.shownOrigin.z;
  return figures;
}
}  // namespace

std::string pathCsv(const path::LiftedPath& path)
{
  const auto& origin = path.shownOrigin;
  std::string text = "x,y,z\n";
  for (const auto& point : path.points)
    text += jsonNumber(point.position.x + origin.x) + "," +
            jsonNumber(point.position.y + origin.y) + "," +
            jsonNumber(point.position.z + origin.z) + "\n";
  return text;
}

std::string pathLengths(const path::LiftedPath& path)
{
  return mrpt::format("%.2f m, %.2f m in 2D", path.length(), path.length2D());
}

std::string pathText(const path::LiftedPath& path)
{
  const PathFigures figures = figuresOf(path);
  std::string text = mrpt::format("points       %zu, z from %.2f to %.2f m\n", path.points.size(),
                                  figures.lowest, figures.highest);
  text += "length       " + pathLengths(path) + "\n";
  if (path.inferredLength > 0)
    text += mrpt::format(
        "inferred     %.2f m of it in 2D lead over ground that was not seen but is inferred\n",
        path.inferredLength);
  text += mrpt::format("heights      %zu from the floor ahead and behind, %zu from the sphere\n",
                       figures.floorAhead, figures.sphere);
  return text;
}

JsonObject pathJson(const path::LiftedPath& path)
{
  const PathFigures figures = figuresOf(path);
  JsonObject json;
  json.add("points", path.points.size()).add("length", path.length());
  json.add("length2D", path.length2D()).add("inferredLength", path.inferredLength);
  json.add("zMin", figures.lowest).add("zMax", figures.highest);
  json.add("heightsFromFloor", figures.floorAhead).add("heightsFromSphere", figures.sphere);
  return json.add("slabsChecked", path.slabsChecked);
}

}  // namespace mapconv
