#include <mrpt_mapconv/freespace/Evidence.h>
#include <mrpt_mapconv/freespace/Layers.h>

#include <cmath>

namespace mrpt_mapconv::freespace
{
const std::vector<Layers::Entry>& Layers::list()
{
  using Kind = grid::LayerKind;
  static const std::vector<Entry> entries{
      {&Layers::floor, "floor", "Floor: bottom of the lowest free range", "m", Kind::Height},
      {&Layers::ceiling, "ceiling", "Ceiling: top of the highest free range", "m", Kind::Height},
      {&Layers::slope, "slope", "Slope of the ground", "m/m", Kind::Slope},
      {&Layers::aerial, "aerial", "Occupancy for an aerial robot", "", Kind::Occupancy},
      {&Layers::ground, "ground", "Occupancy for a ground robot", "", Kind::Occupancy,
       &Layers::aerial, &Layers::evidence},
      {&Layers::support, "support", "Support: height of the ground", "m", Kind::Height},
      {&Layers::evidence, "evidence", "Evidence of the ground", "", Kind::Evidence}};
  return entries;
}

Layers::Layers(const grid::GridFrame& frame)
{
  for (const Entry& entry : list()) this->*entry.member = {frame, grid::unknownCell(entry.kind)};
}

Layers Layers::onFrame(const grid::GridFrame& frame) const
{
  Layers out;
  for (const Entry& entry : list())
    out.*entry.member = (this->*entry.member).onFrame(frame, grid::unknownCell(entry.kind));
  return out;
}

std::vector<grid::StyledLayer> Layers::styled() const
{
  std::vector<grid::StyledLayer> out;
  for (const Entry& entry : list())
    out.push_back({entry.name, &(this->*entry.member), entry.title, entry.unit, entry.kind,
                   entry.freeFor ? &(this->*entry.freeFor) : nullptr,
                   entry.evidence ? &(this->*entry.evidence) : nullptr});
  return out;
}

std::vector<grid::StyledLayer> Layers::styled(const grid::Layer<float>& edges) const
{
  auto out = styled();
  for (grid::StyledLayer& layer : out)
    if (layer.freeFor) layer.drops = &edges;
  return out;
}

grid::StyledLayer Layers::styled(const std::string& name) const
{
  return grid::findLayer(styled(), name);
}

std::vector<std::pair<std::string, const grid::Layer<float>*>> Layers::named() const
{
  std::vector<std::pair<std::string, const grid::Layer<float>*>> out;
  for (const Entry& entry : list()) out.emplace_back(entry.name, &(this->*entry.member));
  return out;
}

LayerStatistics statistics(const Layers& layers)
{
  LayerStatistics count;
  for (std::size_t i = 0; i < layers.aerial.cells().size(); ++i)
  {
    const float aerial = layers.aerial.cells()[i], ground = layers.ground.cells()[i];
    count.groundFree += grid::isFree(ground);
    count.groundOccupied += grid::isOccupied(ground);
    count.groundUnknown += !grid::isFree(ground) && !grid::isOccupied(ground);
    if (grid::isFree(aerial))
    {
      ++count.free;
      count.frontier +=
          layers.evidence.cells()[i] == evidence::kOpen && std::isnan(layers.support.cells()[i]);
      count.inferred += layers.evidence.cells()[i] == evidence::kInferred;
      count.steep += grid::isOccupied(ground);
      count.slopeUnknown += std::isnan(layers.slope.cells()[i]);
    }
    else if (grid::isOccupied(aerial))
      ++count.occupied;
    else
      ++count.unknown;
  }
  return count;
}

}  // namespace mrpt_mapconv::freespace
