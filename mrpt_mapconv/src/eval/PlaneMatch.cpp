#include <mrpt_mapconv/eval/PlaneMatch.h>
#include <mrpt_mapconv/params/Require.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "ComparedMaps.h"

namespace mrpt_mapconv::eval
{
using grid::Layer;

namespace
{
/** Numbers of judged cells. */
struct Regions
{
  std::map<std::int32_t, std::size_t> ofMap, ofTruth;
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> common;  //!< by map, then truth
};

Regions countRegions(const Layer<float>& map, const Layer<float>& height,
                     const Layer<std::int32_t>& truth)
{
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  const auto planes = on(truth.frame(), map, kNaN);
  const auto heights = on(truth.frame(), height, kNaN);
  Regions regions;
  for (std::size_t i = 0; i < truth.cells().size(); ++i)
  {
    const std::int32_t real = truth.cells()[i];
    if (real < 0 || !std::isfinite(heights.cells()[i])) continue;
    ++regions.ofTruth[real];
    if (!std::isfinite(planes.cells()[i])) continue;
    const auto said = static_cast<std::int32_t>(planes.cells()[i]);
    ++regions.ofMap[said];
    ++regions.common[{said, real}];
  }
  return regions;
}
}  // namespace

Agreement matchPlanes(const Layer<float>& map, const Layer<float>& height,
                      const Layer<std::int32_t>& truth, const PlaneMatchParams& params)
{
  params::require(params.overlap > 0.5 && params.overlap <= 1, "overlap", params.overlap,
                  "a share above 0.5, up to 1");
  const Regions regions = countRegions(map, height, truth);
  // more than half of either: no plane is in two pairs
  std::set<std::int32_t> rightOnes, foundOnes;
  const auto covers = [&](std::size_t common, std::size_t all)
  { return static_cast<double>(common) >= params.overlap * static_cast<double>(all); };
  for (const auto& [pair, common] : regions.common)
    if (covers(common, regions.ofMap.at(pair.first)) &&
        covers(common, regions.ofTruth.at(pair.second)))
    {
      rightOnes.insert(pair.first);
      foundOnes.insert(pair.second);
    }
  Agreement agreement;
  for (const auto& [plane, cells] : regions.ofMap)
    if (cells >= params.minCells) ++(rightOnes.count(plane) ? agreement.right : agreement.wrong);
  for (const auto& [plane, cells] : regions.ofTruth)
    if (cells >= params.minCells) ++(foundOnes.count(plane) ? agreement.found : agreement.missed);
  return agreement;
}

}  // namespace mrpt_mapconv::eval
