#include <mrpt_mapconv/eval/CellMask.h>

#include <algorithm>

#include "ComparedMaps.h"

namespace mrpt_mapconv::eval
{
using grid::GridFrame;
using grid::Layer;

CellMask both(const CellMask& a, const CellMask& b)
{
  CellMask mask = on(a.frame(), b, std::uint8_t{0});
  for (std::size_t i = 0; i < mask.cells().size(); ++i)
    mask.cells()[i] = mask.cells()[i] && a.cells()[i];
  return mask;
}

CellMask without(const CellMask& a, const CellMask& b)
{
  CellMask mask = on(a.frame(), b, std::uint8_t{0});
  for (std::size_t i = 0; i < mask.cells().size(); ++i)
    mask.cells()[i] = a.cells()[i] && !mask.cells()[i];
  return mask;
}

CellMask cellsFrom(const Layer<float>& layer, float least)
{
  CellMask mask(layer.frame(), 0);
  for (std::size_t i = 0; i < mask.cells().size(); ++i) mask.cells()[i] = layer.cells()[i] >= least;
  return mask;
}

CellMask freeCells(const Layer<float>& occupancy)
{
  CellMask mask(occupancy.frame(), 0);
  for (std::size_t i = 0; i < mask.cells().size(); ++i)
    mask.cells()[i] = grid::isFree(occupancy.cells()[i]);
  return mask;
}

CellMask inside(const CellMask& mask, std::int32_t reach)
{
  const GridFrame& frame = mask.frame();
  const CellMask all(frame, 1);
  CellMask inner = without(all, around(without(all, mask), reach));
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
      if (x < reach || y < reach || x >= frame.width - reach || y >= frame.height - reach)
        inner.at(x, y) = 0;
  return inner;
}

CellMask around(const CellMask& mask, std::int32_t reach)
{
  const GridFrame& frame = mask.frame();
  CellMask near(frame, 0);
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
    {
      if (!mask.at(x, y)) continue;
      const std::int32_t begin = std::max(x - reach, 0), end = std::min(x + reach + 1, frame.width);
      for (std::int32_t ny = std::max(y - reach, 0); ny <= std::min(y + reach, frame.height - 1);
           ++ny)
        std::fill(near.row(ny) + begin, near.row(ny) + end, std::uint8_t{1});
    }
  return near;
}

std::size_t count(const CellMask& mask)
{
  const auto& cells = mask.cells();
  return cells.size() - static_cast<std::size_t>(std::count(cells.begin(), cells.end(), 0));
}

CellMask cellsOf(const sim::World& world, const std::vector<std::string>& names,
                 const GridFrame& frame)
{
  CellMask mask(frame, 0);
  std::vector<sim::Solid> solids;
  for (std::size_t i = 0; i < world.size(); ++i)
  {
    if (std::none_of(names.begin(), names.end(),
                     [&](const std::string& start) { return world.nameBegins(i, start); }))
      continue;
    for (std::int32_t y = 0; y < frame.height; ++y)
      for (std::int32_t x = 0; x < frame.width; ++x)
      {
        solids.clear();
        const double cx = frame.centreOf(frame.x0 + x);
        const double cy = frame.centreOf(frame.y0 + y);
        const sim::Footprint place = world.primitive(i).footprint();
        if (cx < place.xMin || cx > place.xMax || cy < place.yMin || cy > place.yMax) continue;
        world.primitive(i).appendSolids(cx, cy, solids);
        if (!solids.empty()) mask.at(x, y) = 1;
      }
  }
  return mask;
}

}  // namespace mrpt_mapconv::eval
