#pragma once

#include <mrpt/serialization/CSerializable.h>

namespace mrpt::maps
{
class COctoMap;
class CColouredOctoMap;
}  // namespace mrpt::maps
namespace octomap
{
class AbstractOcTree;
class ColorOcTree;
class OcTree;
}  // namespace octomap

namespace mrpt_mapconv::maps
{
/** The octree inside an MRPT octomap, whose own getOctomap() does not compile outside MRPT's
 * library in 2.5.8. Valid as long as the map. */
const octomap::OcTree& octreeOf(const mrpt::maps::COctoMap& map);
const octomap::ColorOcTree& octreeOf(const mrpt::maps::CColouredOctoMap& map);

/** The octree in a deserialized object: a COctoMap, a CColouredOctoMap, a CFreeSpaceGridMap2D, or a
 * CMultiMetricMap that holds one of these (the first counts). Null if there is none. Valid as long
 * as the object. */
const octomap::AbstractOcTree* octreeIn(const mrpt::serialization::CSerializable& object);

}  // namespace mrpt_mapconv::maps
