#pragma once

#include "output/InfoReport.h"

namespace octomap
{
class AbstractOcTree;
}

namespace mapconv
{
/** Adds the tree's resolution, leaves, bounding box and memory. */
void describeOctree(const octomap::AbstractOcTree& tree, InfoReport& report);

}  // namespace mapconv
