#pragma once

#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>

#include <string>

#include "../oracle/DenseOracle.h"

namespace mrpt_mapconv::test
{
/** The library's layers against the oracle's cells: frame, floor, ceiling, support and
 * evidence to the bit, occupancy
 * to float rounding, slope within 1e-6, ground exactly except where double rounding decides. The
 * message names the first wrong cell. */
::testing::AssertionResult agreesWithOracle(const freespace::Layers& layers,
                                            const oracle::DenseMap& map,
                                            const oracle::DenseResult& expected);

/** The library's counts of its layers against the oracle's; `steep` may differ by the real ties. */
::testing::AssertionResult countsAgree(const freespace::LayerStatistics& counts,
                                       const oracle::DenseResult& expected);

/** All layers the same to the bit, on the same frame. */
::testing::AssertionResult sameBits(const freespace::Layers& a, const freespace::Layers& b);

/** `wide` is `exact` laid on a larger frame to the bit, with unknown cells all around. */
::testing::AssertionResult isPaddedWith(const freespace::Layers& wide,
                                        const freespace::Layers& exact);

std::string text(const freespace::ConversionParams& params);

}  // namespace mrpt_mapconv::test
