#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/system/COutputLogger.h>
#include <mrpt_mapconv/observation/PoseTrack.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mrpt_mapconv::observation
{
/** All that a log says of where the robot was: robot poses and odometry, told apart by their label,
 * and the increments of its actions. */
class PoseSources
{
 public:
  /** Takes an observation. \return false, and nothing taken, if it is no pose */
  bool add(const mrpt::obs::CObservation& obs);
  void add(const mrpt::obs::CActionCollection& actions);

  /** Where the increments have led so far. */
  const mrpt::poses::CPose3D& summedUp() const { return m_summedUp; }
  bool empty() const { return m_increments == 0 && m_robotPoses.empty() && m_odometry.empty(); }
  /** What is wrong with the poses that were not taken, "2 poses without a time stamp"; empty if
   * nothing is. */
  std::string faults() const;

  /** The poses that are wanted, or else those that come first; not to be asked if empty().
   * \param wanted name or label of a source
   * \param log told if there are several and nobody has chosen; may be null
   * \return null for the increments
   * \exception std::runtime_error if there is no such source, naming those there are */
  const PoseTrack* choose(const std::optional<std::string>& wanted,
                          const mrpt::system::COutputLogger* log) const;

 private:
  using Tracks = std::map<std::string, PoseTrack>;  //!< by label
  struct Source
  {
    std::string kind, label, name;
    std::size_t poses;
    const PoseTrack* track;  //!< null: the increments
  };

  bool add(Tracks& tracks, const mrpt::obs::CObservation& obs, const mrpt::poses::CPose3D& pose,
           const std::optional<HeightCovariance>& covariance);
  /** In the order in which they are preferred. */
  std::vector<Source> sources() const;

  Tracks m_robotPoses, m_odometry;
  mrpt::poses::CPose3D m_summedUp;
  std::size_t m_increments = 0;
  std::size_t m_withoutTime = 0, m_notFinite = 0;
};

}  // namespace mrpt_mapconv::observation
