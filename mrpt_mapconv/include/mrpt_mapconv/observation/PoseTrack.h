#pragma once

#include <mrpt/math/TBoundingBox.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/system/datetime.h>
#include <mrpt_mapconv/observation/PoseCovariance.h>

#include <cstddef>
#include <map>
#include <optional>

namespace mrpt_mapconv::observation
{
/** The robot's poses over time, interpolated between the ones that are known. */
class PoseTrack
{
 public:
  /** How far outside its time span the track still answers, with its first or last pose [s]: one
   * turn of a lidar at 10 Hz, since sensor and localization rarely start together. */
  static constexpr double kTolerance = 0.1;
  /** How far both poses around a time may be from it [s]: what happens between poses that are
   * farther apart is anybody's guess. */
  static constexpr double kMaxGap = 1.0;

  /** Adds a pose; one of the same time is replaced.
   * \param covariance of it, if it is known
   * \return false, and nothing added, for an invalid time or a pose that is not finite */
  bool insert(mrpt::system::TTimeStamp time, const mrpt::poses::CPose3D& pose,
              const std::optional<HeightCovariance>& covariance = {});

  /** The pose that was added for exactly this time, if one was. */
  std::optional<mrpt::poses::CPose3D> knownAt(mrpt::system::TTimeStamp time) const;

  bool empty() const { return m_poses.empty(); }
  std::size_t size() const { return m_poses.size(); }
  /** Times of the first and last pose, of a track that is not empty. @{ */
  mrpt::system::TTimeStamp begin() const { return m_poses.begin()->first; }
  mrpt::system::TTimeStamp end() const { return m_poses.rbegin()->first; }
  /** @} */
  /** The box around the positions of a track that is not empty [m]. */
  mrpt::math::TBoundingBox bounds() const;

  /** What the track knows of a time. */
  enum class Coverage
  {
    Known,
    NoTime,   //!< the time itself is not valid
    Outside,  //!< more than kTolerance before the first pose or behind the last one
    Gap       //!< between two poses of which one is too far away
  };
  /** \param maxGap how far both neighbouring poses may be from a time between them [s] */
  Coverage coverage(mrpt::system::TTimeStamp time, double maxGap = kMaxGap) const;

  /** The pose at a time: position linear and orientation slerp between the neighbours; the first or
   * last pose up to kTolerance outside; nothing unless the time is Coverage::Known. */
  std::optional<mrpt::poses::CPose3D> at(mrpt::system::TTimeStamp time,
                                         double maxGap = kMaxGap) const;
  /** The covariance of that pose, linear between the neighbours' too; nothing where there is no
   * pose, or one of them has none. */
  std::optional<HeightCovariance> covarianceAt(mrpt::system::TTimeStamp time,
                                               double maxGap = kMaxGap) const;
  /** Time between the two poses around a time [s]; 0 if there are not two. */
  double gapAt(mrpt::system::TTimeStamp time) const;

 private:
  struct Pose
  {
    mrpt::poses::CPose3D mean;
    std::optional<HeightCovariance> covariance;
  };
  /** The two poses around a known time and its share of the way between them; the same one twice
   * where there is but one. */
  struct Around
  {
    const Pose &before, &after;
    double share;
  };
  Around around(mrpt::system::TTimeStamp time) const;

  std::map<mrpt::system::TTimeStamp, Pose> m_poses;
};

}  // namespace mrpt_mapconv::observation
