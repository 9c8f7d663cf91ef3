#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>

#include "DenseMap.h"
#include "DenseOracle.h"

namespace mrpt_mapconv::oracle
{
/** Which cells are seen, open, walls or nothing, after findHeights(). */
void markEvidence(const DenseMap& map, DenseResult& result);

/** With floorFrom = lowestFree the floor bears whatever is known of what is under it. */
void supportIsFloor(double resolution, DenseResult& result);

/** With floorFrom = seen, after markEvidence() and markAerial(): support, and by it slope and
 * ground layer. */
void judgeBySupport(double resolution, const freespace::ConversionParams& params,
                    DenseResult& result);

}  // namespace mrpt_mapconv::oracle
