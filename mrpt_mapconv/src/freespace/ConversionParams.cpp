#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace mrpt_mapconv::freespace
{
using params::require;

namespace
{
constexpr double kSlack = 1e-6;  // of a voxel: metres that mean a whole number of voxels give it

/** Keys are 16 bits wide, so more voxels than that mean the same; this keeps the cast in range. */
std::int32_t toVoxels(double count)
{
  return static_cast<std::int32_t>(std::clamp(count, 0.0, 1e6));
}
}  // namespace

void ConversionParams::check() const
{
  require(std::isfinite(minClearance) && minClearance >= 0, "minClearance", minClearance,
          "a finite height ≥ 0 m");
  require(minOccupancy >= 0 && minOccupancy <= 1, "minOccupancy", minOccupancy, "within [0, 1]");
  require(slopeWindow >= 1 && slopeWindow <= 100, "slopeWindow", slopeWindow,
          "a whole number of cells from 1 to 100");
  require(std::isfinite(maxSlope) && maxSlope >= 0, "maxSlope", maxSlope, "a finite slope ≥ 0");
  const double step = maxStep.value_or(0);
  require(std::isfinite(step) && step >= 0, "maxStep", step,
          "a finite height ≥ 0 m (0 turns it off) or auto");
  require(std::isfinite(maxGap) && maxGap >= 0, "maxGap", maxGap, "a finite length ≥ 0 m");
  require(std::isfinite(maxHiddenGap) && maxHiddenGap >= 0, "maxHiddenGap", maxHiddenGap,
          "a finite length ≥ 0 m");
}

void ConversionParams::takeNamedSet()
{
  minClearance = 1.0;
  minOccupancy = 0.5;
  slopeWindow = 2;
  maxSlope = 2.0;
  maxStep = 0.0;
  floorFrom = FloorFrom::LowestFree;
}

ConversionParams ConversionParams::paper()
{
  ConversionParams params;
  params.takeNamedSet();
  return params;
}

ConversionParams ConversionParams::ofOlderFiles()
{
  ConversionParams params;
  params.floorFrom = FloorFrom::LowestFree;
  return params;
}

std::int32_t ConversionParams::minRunVoxels(double resolution) const
{
  return std::max(1, toVoxels(std::ceil(minClearance / resolution - kSlack)));
}

double ConversionParams::stepHeight(double resolution) const
{
  constexpr double kAutoStep = 0.2;  // [m]
  return maxStep.value_or(0) > 0 ? *maxStep : std::max(kAutoStep, resolution);
}

std::int32_t ConversionParams::maxStepVoxels(double resolution) const
{
  return toVoxels(std::floor(stepHeight(resolution) / resolution + kSlack));
}

double ConversionParams::minStep(double resolution) const
{
  return maxSlope * resolution * (2 * slopeWindow + 1) / 1.5;
}

double ConversionParams::minThinWall(double resolution) const
{
  return maxSlope * resolution * (slopeWindow + 1) * (2 * slopeWindow + 1) / 3;
}

}  // namespace mrpt_mapconv::freespace
