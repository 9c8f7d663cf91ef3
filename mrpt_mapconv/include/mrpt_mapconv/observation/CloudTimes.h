#pragma once

#include <mrpt/system/datetime.h>
#include <mrpt_mapconv/observation/PoseTrack.h>

namespace mrpt_mapconv::observation
{
/** How a cloud's times become those of a trajectory: trajectory = unit · cloud + offset. */
struct CloudTimes
{
  double unit = 1;                     //!< of the cloud's times [s]
  double offset = 0;                   //!< [s]
  double maxGap = PoseTrack::kMaxGap;  //!< how far both poses around a time may be from it [s]

  /** In the trajectory; not valid for a time that is not finite, or millennia away. */
  mrpt::system::TTimeStamp stampOf(double cloudTime) const;
};

}  // namespace mrpt_mapconv::observation
