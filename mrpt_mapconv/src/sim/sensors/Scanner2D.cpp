#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <algorithm>
#include <utility>

#include "SensorKinds.h"

namespace mrpt_mapconv::sim
{
using mrpt::obs::CObservation2DRangeScan;

namespace
{
/** A scanner in one plane. Rays without return have MRPT's mark of that: the largest range, not
 * valid. */
class Scanner2D : public Sensor
{
 public:
  Scanner2D(SensorParams params, std::vector<mrpt::math::TPoint3Df> directions, double aperture)
      : Sensor(std::move(params), std::move(directions)), m_aperture(static_cast<float>(aperture))
  {
  }
  bool is3D() const override { return false; }

 protected:
  mrpt::obs::CObservation::Ptr observation(const std::vector<float>& ranges) const override
  {
    auto scan = CObservation2DRangeScan::Create();
    scan->aperture = m_aperture;
    scan->rightToLeft = true;
    scan->maxRange = static_cast<float>(params().maxRange);
    scan->stdError = static_cast<float>(std::max(params().rangeNoise, 1e-3));
    scan->resizeScanAndAssign(ranges.size(), scan->maxRange, false);
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
      if (ranges[i] <= 0) continue;
      scan->setScanRange(i, ranges[i]);
      scan->setScanRangeValidity(i, true);
    }
    return scan;
  }

 private:
  float m_aperture;  //!< [rad]
};
}  // namespace

std::unique_ptr<Sensor> readScanner2D(params::StrictSection& section, SensorParams params)
{
  const double fov = readWithin(section, "fieldOfView", 1, 360);
  const int rays = readCount(section, "rays", 2, 100000);
  std::vector<mrpt::math::TPoint3Df> directions;
  directions.reserve(static_cast<std::size_t>(rays));
  for (int i = 0; i < rays; ++i)
    directions.push_back(directionAt(fov * i / (rays - 1) - fov / 2, 0));
  return std::make_unique<Scanner2D>(std::move(params), std::move(directions), mrpt::DEG2RAD(fov));
}

}  // namespace mrpt_mapconv::sim
