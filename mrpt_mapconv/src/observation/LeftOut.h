#pragma once

#include <mrpt/core/format.h>
#include <mrpt_mapconv/observation/PoseTrack.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace mrpt_mapconv::observation
{
/** The scans whose pose a track does not know, and why. */
class LeftOut
{
 public:
  explicit LeftOut(double maxGap) : m_maxGap(maxGap) {}

  void add(const PoseTrack& track, mrpt::system::TTimeStamp time)
  {
    const auto coverage = track.coverage(time, m_maxGap);
    m_noTime += coverage == PoseTrack::Coverage::NoTime;
    m_outside += coverage == PoseTrack::Coverage::Outside;
    if (coverage != PoseTrack::Coverage::Gap) return;
    ++m_inGaps;
    m_longestGap = std::max(m_longestGap, track.gapAt(time));
  }

  std::size_t count() const { return m_inGaps + m_outside + m_noTime; }

  /** How many for which reason. */
  std::string reasons() const
  {
    std::string text;
    const auto append = [&text](std::size_t count, const std::string& why)
    {
      if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + why;
    };
    append(m_inGaps,
           mrpt::format("in gaps between the poses (the longest is %.1f s)", m_longestGap));
    append(m_outside, "outside the time span of the poses");
    append(m_noTime, "without a time stamp");
    return text;
  }
  /** What takes those in gaps; empty if there are none. */
  std::string remedy() const
  {
    if (m_inGaps == 0) return "";
    return mrpt::format(
        "; both poses around a scan must be within %g s of it (--max-pose-gap allows more)",
        m_maxGap);
  }

 private:
  double m_maxGap;
  std::size_t m_inGaps = 0, m_outside = 0, m_noTime = 0;
  double m_longestGap = 0;
};

}  // namespace mrpt_mapconv::observation
