#pragma once

namespace mrpt_mapconv::voxel
{
/** Between which log-odds stay. */
struct ClampingRange
{
  float min, max;

  float clamp(float logOdds) const
  {
    // written such that compilers make it two instructions and no branch, which would be wrong at
    // every other voxel
    const float above = logOdds > min ? logOdds : min;
    return above < max ? above : max;
  }
};

}  // namespace mrpt_mapconv::voxel
