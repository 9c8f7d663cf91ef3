#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "SensorKinds.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3Df;
using mrpt::obs::CObservation3DRangeScan;

namespace
{
/** A pinhole camera; pixel centres have whole coordinates and the axis goes through the middle. */
struct Pinhole
{
  int width, height;  //!< [pixels]
  double focal;       //!< [pixels]
  double centreX() const { return (width - 1) / 2.0; }
  double centreY() const { return (height - 1) / 2.0; }
};

/** The finest of 1e-4, 1e-3, … m with which 16 bits hold the largest range. */
float unitFor(double maxRange)
{
  double unit = 1e-4;
  while (maxRange / unit > 65535) unit *= 10;
  return static_cast<float>(unit);
}

/** A camera that gives for each pixel the depth along its axis. */
class DepthCamera : public Sensor
{
 public:
  DepthCamera(SensorParams params, std::vector<TPoint3Df> directions, const Pinhole& pinhole)
      : Sensor(std::move(params), std::move(directions)), m_pinhole(pinhole)
  {
  }

 protected:
  mrpt::obs::CObservation::Ptr observation(const std::vector<float>& ranges) const override
  {
    auto scan = CObservation3DRangeScan::Create();
    scan->range_is_depth = true;
    scan->maxRange = static_cast<float>(params().maxRange);
    scan->stdError = static_cast<float>(std::max(params().rangeNoise, 1e-3));
    scan->rangeUnits = unitFor(params().maxRange);
    scan->cameraParams.ncols = static_cast<std::uint32_t>(m_pinhole.width);
    scan->cameraParams.nrows = static_cast<std::uint32_t>(m_pinhole.height);
    scan->cameraParams.setIntrinsicParamsFromValues(m_pinhole.focal, m_pinhole.focal,
                                                    m_pinhole.centreX(), m_pinhole.centreY());
    scan->hasRangeImage = true;
    scan->rangeImage_setSize(m_pinhole.height, m_pinhole.width);
    std::size_t i = 0;
    for (int row = 0; row < m_pinhole.height; ++row)
      for (int column = 0; column < m_pinhole.width; ++column, ++i)
        scan->rangeImage(row, column) = static_cast<std::uint16_t>(
            std::lround(ranges[i] * directions()[i].x / scan->rangeUnits));
    return scan;
  }

 private:
  Pinhole m_pinhole;
};
}  // namespace

std::unique_ptr<Sensor> readDepthCamera(params::StrictSection& section, SensorParams params)
{
  const int width = readCount(section, "width", 2, 10000);
  const int height = readCount(section, "height", 2, 10000);
  const double fov = readWithin(section, "fieldOfView", 1, 170);
  const Pinhole pinhole{width, height, width / 2.0 / std::tan(mrpt::DEG2RAD(fov) / 2)};
  std::vector<TPoint3Df> directions;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
    {
      const double y = (pinhole.centreX() - column) / pinhole.focal;
      const double z = (pinhole.centreY() - row) / pinhole.focal;
      const double length = std::sqrt(1 + y * y + z * z);
      directions.emplace_back(static_cast<float>(1 / length), static_cast<float>(y / length),
                              static_cast<float>(z / length));
    }
  return std::make_unique<DepthCamera>(std::move(params), std::move(directions), pinhole);
}

}  // namespace mrpt_mapconv::sim
