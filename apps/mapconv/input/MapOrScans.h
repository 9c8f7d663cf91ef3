#pragma once

#include <mrpt/serialization/CSerializable.h>
#include <mrpt_mapconv/files/ObjectFile.h>

#include <optional>
#include <string>

#include "input/ScanFile.h"

namespace octomap
{
class AbstractOcTree;
}

namespace mapconv
{
/** What a file of MRPT's objects has to offer: scans or an octomap. */
struct MapOrScans
{
  std::optional<LogKind> scans;                    //!< the file stands at the log's first entry
  mrpt::serialization::CSerializable::Ptr object;  //!< owns the tree
  const octomap::AbstractOcTree* tree = nullptr;   //!< not empty; null if it is scans
  std::string description = {};                    //!< of the tree, e.g. "COctoMap (OcTree)"
};

/** Finds the first of both.
 * \exception std::runtime_error in one line naming the file, if there is neither or the octomap is
 * empty */
MapOrScans findMapOrScans(mrpt_mapconv::files::ObjectFile& file);

}  // namespace mapconv
