#pragma once

#include <mrpt_mapconv/eval/MapRegion.h>
#include <mrpt_mapconv/eval/ScanShapeMaps.h>
#include <mrpt_mapconv/eval/ScanShapeScores.h>

#include <vector>

namespace mrpt_mapconv::eval
{
/** Ways to tell what lies in a room. */
template <class Value>
struct PerRegionMap
{
  Value real;        //!< without the cut, of the returns that were not reflected on their way
  Value uncut, cut;  //!< whole shapes
};

/** The profiles of one scan. */
using RegionProfiles = PerRegionMap<const scan::ScanProfile&>;

/** What is seen of a region from outside its room. */
struct OutsideScore
{
  std::size_t scans = 0;  //!< how many are taken there
  PerRegionMap<RegionScore> maps;
};

/** Maps for each region, made of the scans from outside its room only. */
class OutsideMaps
{
 public:
  /** \param margin how far outside their sensor is at least [m] */
  OutsideMaps(const grid::GridFrame& frame, const std::vector<MapRegion>& regions, double margin,
              const scan::UpdateParams& update);

  /** Puts a scan into the maps of the regions of which its sensor is outside. */
  void add(const scan::Viewpoint& view, const RegionProfiles& profiles);
  /** Judges the maps of each region by the truth. */
  std::vector<OutsideScore> judged(const ScanShapeTruth& truth) const;

 private:
  struct Outside
  {
    sim::Footprint room;  //!< with the margin
    PerRegionMap<UpdatedGrid> grids;
    std::size_t scans = 0;
  };

  std::vector<Outside> m_outsides;  //!< one for each region
};

}  // namespace mrpt_mapconv::eval
