#pragma once

#include <mrpt_mapconv/aerial/Ground.h>

#include <cstddef>
#include <string>

#include "output/Summary.h"

namespace mapconv
{
/** What a run of `ground` has to tell. */
struct GroundResult
{
  mrpt_mapconv::aerial::GroundParams params;
  mrpt_mapconv::aerial::Ground ground;
  std::string pointsFile;  //!< where the classified cloud went; empty: nowhere
};

std::string groundText(const SummaryHead& head, const GroundResult& result, const Seconds& seconds);
std::string groundJson(const SummaryHead& head, const GroundResult& result, const Seconds& seconds);

/** Warns of a cloth that did not come to rest, and of cells that are far smaller than the distances
 * of the points. */
void warnAboutGround(const GroundResult& result);

}  // namespace mapconv
