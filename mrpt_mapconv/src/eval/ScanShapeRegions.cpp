#include <mrpt_mapconv/eval/ScanShapeRegions.h>

namespace mrpt_mapconv::eval
{
namespace
{
sim::Footprint grown(const sim::Footprint& room, double margin)
{
  return {room.xMin - margin, room.yMin - margin, room.xMax + margin, room.yMax + margin};
}
}  // namespace

OutsideMaps::OutsideMaps(const grid::GridFrame& frame, const std::vector<MapRegion>& regions,
                         double margin, const scan::UpdateParams& update)
{
  const UpdatedGrid empty(frame, update);
  for (const MapRegion& region : regions)
    m_outsides.push_back({grown(region.room, margin), {empty, empty, empty}, 0});
}

void OutsideMaps::add(const scan::Viewpoint& view, const RegionProfiles& profiles)
{
  for (Outside& outside : m_outsides)
  {
    if (holds(outside.room, view.sensorPose.x(), view.sensorPose.y())) continue;
    outside.grids.real.add(profiles.real);
    outside.grids.uncut.add(profiles.uncut);
    outside.grids.cut.add(profiles.cut);
    ++outside.scans;
  }
}

std::vector<OutsideScore> OutsideMaps::judged(const ScanShapeTruth& truth) const
{
  std::vector<OutsideScore> scores;
  for (std::size_t i = 0; i < m_outsides.size(); ++i)
  {
    const auto score = [&](const UpdatedGrid& grid)
    { return scoreRegion(grid.labels(), truth, i); };
    const auto& grids = m_outsides[i].grids;
    scores.push_back(
        {m_outsides[i].scans, {score(grids.real), score(grids.uncut), score(grids.cut)}});
  }
  return scores;
}

}  // namespace mrpt_mapconv::eval
