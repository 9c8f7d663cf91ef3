#include <mrpt_mapconv/aerial/GroundParams.h>
#include <mrpt_mapconv/params/Require.h>

namespace mrpt_mapconv::aerial
{
using params::require;

namespace
{
bool within(double value, double least, double most) { return value >= least && value <= most; }

void checkCloth(const GroundParams& p)
{
  require(within(p.clothResolution, 0.01, 100), "clothResolution", p.clothResolution,
          "within 0.01 and 100 m");
  require(p.rigidness >= 1 && p.rigidness <= 15, "rigidness", p.rigidness, "within 1 and 15");
  require(within(p.heightThreshold, 0, 100), "heightThreshold", p.heightThreshold,
          "within 0 and 100 m");
  require(within(p.heightScale, 0, 100), "heightScale", p.heightScale, "within 0 and 100 m");
  require(within(p.timeStep, 0.01, 2), "timeStep", p.timeStep, "within 0.01 and 2");
  require(within(p.gravity, 1e-6, 100), "gravity", p.gravity, "within 0.000001 and 100");
  require(within(p.damping, 0, 1), "damping", p.damping, "within 0 and 1");
  require(p.maxIterations >= 1 && p.maxIterations <= 1000000, "maxIterations", p.maxIterations,
          "within 1 and 1000000");
  require(p.restMove >= 0 && p.restMove < p.firstMove(), "restMove", p.restMove,
          "at least 0 m and less than the cloth's first move, gravity * timeStep^4");
  require(within(p.smoothingSlope, 0, 10), "smoothingSlope", p.smoothingSlope,
          "within 0 and 10 m/m");
  require(within(p.smoothingReach, 0, 20 * p.clothResolution), "smoothingReach", p.smoothingReach,
          "within 0 m and 20 times clothResolution");
}

void checkSmrf(const GroundParams& p)
{
  require(within(p.smrfCell, 0.01, 100), "smrfCell", p.smrfCell, "within 0.01 and 100 m");
  require(within(p.smrfSlope, 0, 10), "smrfSlope", p.smrfSlope, "within 0 and 10 m/m");
  require(within(p.smrfWindow, p.smrfCell, 200 * p.smrfCell), "smrfWindow", p.smrfWindow,
          "within 1 and 200 times smrfCell");
  require(within(p.smrfThreshold, 0, 100), "smrfThreshold", p.smrfThreshold, "within 0 and 100 m");
  require(within(p.smrfScale, 0, 100), "smrfScale", p.smrfScale, "within 0 and 100 m");
}
}  // namespace

const std::vector<std::string>& namesOf(GroundFilter)
{
  static const std::vector<std::string> names{"csf", "smrf"};
  return names;
}

const std::vector<std::string>& namesOf(CollisionRule)
{
  static const std::vector<std::string> names{"lowest", "nearest"};
  return names;
}

double GroundParams::firstMove() const
{
  return gravity * timeStep * timeStep * timeStep * timeStep;
}

void GroundParams::check() const
{
  require(within(cellSize, 0.01, 100), "cellSize", cellSize, "within 0.01 and 100 m");
  require(within(lowPointRadius, 0, 1000), "lowPointRadius", lowPointRadius,
          "a radius up to 1000 m, or 0 for none");
  require(within(lowPointDepth, 0, 1000), "lowPointDepth", lowPointDepth, "within 0 and 1000 m");
  require(within(lowPointShare, 0, 1), "lowPointShare", lowPointShare, "within 0 and 1");
  checkCloth(*this);
  checkSmrf(*this);
}

}  // namespace mrpt_mapconv::aerial
