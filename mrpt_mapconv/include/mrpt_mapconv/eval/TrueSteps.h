#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/sim/Trajectory.h>
#include <mrpt_mapconv/sim/World.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <cmath>
#include <optional>
#include <vector>

namespace mrpt_mapconv::eval
{
/** A true step, where a line goes over it. */
struct TrueStep
{
  double x = 0, y = 0;                    //!< [m]
  double directionX = 0, directionY = 0;  //!< along the line, upwards, of length 1
  double height = 0;                      //!< [m]
  double depth = NAN;  //!< of the upper tread up to the next step on the line [m]; NaN: there is
                       //!< none
};

/** The steps of the lowest solid's top along a line, from its start on, to 1e-6 m. Between two
 * steps must be at least 1 mm; a slope above jump per mm is taken for steps.
 *
 * \param jump what a step is higher than [m]
 * \exception std::invalid_argument unless jump > 0 and the line's ends differ */
std::vector<TrueStep> trueSteps(const sim::World& world, const mrpt::math::TPoint2D& from,
                                const mrpt::math::TPoint2D& to, double jump);

/** Those along a robot's way, in the order in which it goes over them, as it goes straight on: a
 * step that it crosses twice is there twice. \exception std::invalid_argument unless jump > 0 */
std::vector<TrueStep> trueSteps(const sim::World& world, const sim::Trajectory& way, double jump);

/** The step of a map that stands for a true one: in about its direction (cosine at least 0.9), at
 * most `reach` before or behind it [m], and as far as that to either side of the step's width; of
 * several the nearest in the direction. */
std::optional<terrain::TerrainStep> stepFor(const TrueStep& truth,
                                            const std::vector<terrain::TerrainStep>& steps,
                                            double reach);

/** A true step, and the one that a map has for it. */
struct StepMatch
{
  TrueStep truth;
  std::optional<terrain::TerrainStep> found;

  double heightError() const { return found ? found->height - truth.height : NAN; }  //!< [m]
  double depthError() const { return found ? found->depth - truth.depth : NAN; }     //!< [m]
};

/** True steps with those of a map that lie at most 0.1 m away, as stepFor() finds them. */
std::vector<StepMatch> matchSteps(const std::vector<TrueStep>& truth,
                                  const terrain::TerrainMap& map);

}  // namespace mrpt_mapconv::eval
