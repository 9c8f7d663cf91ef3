#include <mrpt/core/bits_math.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/terrain/TerrainParams.h>

#include <cmath>

namespace mrpt_mapconv::terrain
{
using params::require;

const std::vector<std::string>& namesOf(HeightRule)
{
  static const std::vector<std::string> names{"fused", "maximum"};
  return names;
}

void TerrainParams::check() const
{
  const auto within = [](double value, double least, double most)
  { return value >= least && value <= most; };
  require(within(planeTolerance, 1e-4, 10), "planeTolerance", planeTolerance,
          "within 0.0001 and 10 m");
  require(within(planeWindow, 0, 100), "planeWindow", planeWindow, "within 0 and 100 m");
  require(hypotheses >= 1 && hypotheses <= kMostHypotheses, "hypotheses", hypotheses,
          "within 1 and 64");
  require(blockCells >= 1 && blockCells <= 1000, "blockCells", blockCells, "within 1 and 1000");
  require(minPlaneCells >= 3, "minPlaneCells", minPlaneCells,
          "at least 3, which is what a plane needs");
  require(within(minPlaneWidth, 0, 100), "minPlaneWidth", minPlaneWidth, "within 0 and 100 m");
  require(within(maxPlaneSlope, 0, 10), "maxPlaneSlope", maxPlaneSlope, "within 0 and 10 m/m");
  require(within(maxSlope, 0, 1e6), "maxSlope", maxSlope, "a slope >= 0 m/m");
  require(maxSlope <= maxPlaneSlope, "maxSlope", maxSlope,
          "at most maxPlaneSlope, since steeper ground has no plane whose slope could be judged");
  require(within(maxStep, 0, 1e6), "maxStep", maxStep, "a height >= 0 m");
  require(within(localWindow, 0, 1e6), "localWindow", localWindow, "a side > 0 m, or 0 for none");
}

void PointSigmas::check() const
{
  const auto isSigma = [](double value, double most) { return value >= 0 && value <= most; };
  require(isSigma(range, 1e3), "rangeSigma", range, "a standard deviation >= 0 m");
  require(isSigma(beam, 1), "beamSigma", beam, "within 0 and 1 rad");
  require(isSigma(height, 1e3), "heightSigma", height, "a standard deviation >= 0 m");
  require(isSigma(roll, 90), "rollSigma", roll, "within 0 and 90 degrees");
  require(isSigma(pitch, 90), "pitchSigma", pitch, "within 0 and 90 degrees");
}

mrpt::math::CMatrixDouble33 PointSigmas::poseCovariance() const
{
  mrpt::math::CMatrixDouble33 covariance;
  covariance.setZero();
  const double sigmas[] = {height, mrpt::DEG2RAD(roll), mrpt::DEG2RAD(pitch)};
  for (int i = 0; i < 3; ++i) covariance(i, i) = sigmas[i] * sigmas[i];
  return covariance;
}

}  // namespace mrpt_mapconv::terrain
