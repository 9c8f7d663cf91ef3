#include <mrpt/maps/CColouredOctoMap.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COctoMap.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/OctoMapAccess.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>

// MRPT declares this struct in its public header but defines it in a private one, which Debian does
// not ship; without a definition getOctomap() cannot compile. These repeat its only member.
namespace mrpt::maps
{
template <>
struct COctoMapBase<octomap::OcTree, octomap::OcTreeNode>::Impl
{
  octomap::OcTree m_octomap;
};
template <>
struct COctoMapBase<octomap::ColorOcTree, octomap::ColorOcTreeNode>::Impl
{
  octomap::ColorOcTree m_octomap;
};
}  // namespace mrpt::maps

namespace mrpt_mapconv::maps
{
namespace
{
/** MRPT offers no const access; nothing is changed through it here. */
template <class Tree, class Map>
const Tree& octreeInside(const Map& map)
{
  struct Access : Map
  {
    static const Tree& of(const Map& m) { return (m.*(&Access::m_impl))->m_octomap; }
  };
  return Access::of(map);
}
}  // namespace

const octomap::OcTree& octreeOf(const mrpt::maps::COctoMap& map)
{
  return octreeInside<octomap::OcTree>(map);
}

const octomap::ColorOcTree& octreeOf(const mrpt::maps::CColouredOctoMap& map)
{
  return octreeInside<octomap::ColorOcTree>(map);
}

const octomap::AbstractOcTree* octreeIn(const mrpt::serialization::CSerializable& object)
{
  if (const auto* plain = dynamic_cast<const mrpt::maps::COctoMap*>(&object))
    return &octreeOf(*plain);
  if (const auto* color = dynamic_cast<const mrpt::maps::CColouredOctoMap*>(&object))
    return &octreeOf(*color);
  if (const auto* ours = dynamic_cast<const CFreeSpaceGridMap2D*>(&object)) return &ours->octree();
  if (const auto* several = dynamic_cast<const mrpt::maps::CMultiMetricMap*>(&object))
    for (const auto& map : several->maps)
      if (const auto* tree = map ? octreeIn(*map) : nullptr) return tree;
  return nullptr;
}

}  // namespace mrpt_mapconv::maps
