#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt_mapconv/params/StrictSection.h>
#include <mrpt_mapconv/sim/RayCaster.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace mrpt_mapconv::sim
{
/** What every sensor has. */
struct SensorParams
{
  std::string name;           //!< the label of its observations
  mrpt::poses::CPose3D pose;  //!< sensor -> robot
  double rate = 0;            //!< scans per second [Hz]
  double minRange = 0.1;      //!< surfaces nearer than that are not seen, but hide others [m]
  double maxRange = 0;        //!< nor those beyond [m]
  double rangeNoise = 0;      //!< standard deviation along the ray [m]
  double dropout = 0;         //!< share of returns that are missing, from 0 to below 1
  bool spare = false;         //!< only used where it is asked for by its name
};

/** What a sensor sees at one instant. */
struct Scan
{
  mrpt::obs::CObservation::Ptr observation;  //!< labelled and posed; it has no time yet
  bool is3D = false;
  // of its returns, one for each point of the observation, in its order:
  /** Where they come from, without noise, in the map's frame [m]; those of ghosts are where the ray
   * was reflected to, not where the sensor takes them to be. */
  std::vector<mrpt::math::TPoint3Df> truePoints;
  std::vector<std::int32_t> bodies;    //!< which returned them: numbers in the world
  std::vector<std::uint8_t> mirrored;  //!< 1: a ghost, the ray was reflected on its way
};

/** A range sensor: a fixed bundle of rays, all cast at one instant.
 *
 * A ray that meets a body of mirror m at an angle a to the normal is reflected with probability
 * m + (1 − m)(1 − cos a)⁵ (Schlick 1994), if m > 0. It then meets what is there; the sensor takes
 * the length of all of the way for the range along the direction that it looked in: a ghost.
 *
 * Of the rays that are not reflected, a share t goes on through a body of transparency t, whatever
 * its number of faces. After 8 bodies that a ray went through or was reflected by, the next one
 * returns it.
 */
class Sensor
{
 public:
  virtual ~Sensor() = default;
  const SensorParams& params() const { return m_params; }
  /** Number of rays of a scan. */
  std::size_t rays() const { return m_directions.size(); }
  virtual bool is3D() const { return true; }

  /** \param robotPose robot -> map
   * \param key for what is random in it: the same key gives the same scan */
  Scan scan(const RayCaster& caster, const mrpt::poses::CPose3D& robotPose,
            std::uint64_t key) const;

 protected:
  /** \param directions of the rays in the sensor's frame, of length 1 */
  Sensor(SensorParams params, std::vector<mrpt::math::TPoint3Df> directions);
  /** \param ranges of all rays [m]; 0: no return */
  virtual mrpt::obs::CObservation::Ptr observation(const std::vector<float>& ranges) const = 0;
  const std::vector<mrpt::math::TPoint3Df>& directions() const { return m_directions; }

 private:
  SensorParams m_params;
  std::vector<mrpt::math::TPoint3Df> m_directions;
};

/** Reads a section [sensor.NAME]. All kinds have
 * \code
 * kind = lidar              // lidar | depthCamera | scanner2D
 * pose = 0 0 0.9  0 0 0     // x y z yaw pitch roll on the robot [m, degrees]; default: all 0
 * rate = 5                  // [Hz]
 * minRange = 0.1            // [m]; what is nearer gives no return; default 0.1 or maxRange/2
 * maxRange = 15             // [m]
 * rangeNoise = 0.01         // standard deviation [m]; default 0
 * dropout = 0.01            // share of missing returns, below 1; default 0
 * spare = true              // only used where it is asked for by its name; default false
 * \endcode
 * - lidar gives a CObservationPointCloud: `azimuthSteps` per turn, and `elevations` [degrees], or
 *   `beams` evenly from `elevationMin` to `elevationMax` [degrees];
 * - depthCamera gives a CObservation3DRangeScan with a range image of depths: `width` and `height`
 *   [pixels], `fieldOfView` across the width [degrees];
 * - scanner2D gives a CObservation2DRangeScan: `rays` over `fieldOfView` [degrees], counter-
 *   clockwise.
 *
 * \exception std::runtime_error in one line naming section, key and value, and what would be right;
 * also for a key that this kind does not have */
std::unique_ptr<Sensor> readSensor(params::StrictSection& section);

/** What `kind` may be. */
std::vector<std::string> sensorKinds();

}  // namespace mrpt_mapconv::sim
