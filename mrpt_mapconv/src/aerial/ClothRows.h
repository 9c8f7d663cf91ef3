#pragma once

#include <cstddef>

namespace mrpt_mapconv::aerial
{
/** What a constraint does to its ends, as shares of their difference. */
struct Pull
{
  float bothFree;  //!< for either end if both can move
  float oneFree;   //!< for the end that can move

  /** Of that many passes in one, each of which moves the ends by 0.3 of what is left. */
  static Pull ofPasses(int passes);
};

/** A row of n particles: heights, and 1 for each that can move, else 0. */
struct ParticleRow
{
  float* z;
  const float* free;
};

/** Pulls together each particle and the one `step` farther on in the row, all at once.
 * \param before n floats of scratch memory */
void pullAlong(const ParticleRow& row, std::size_t n, std::size_t step, const Pull& pull,
               float* before);
/** Pulls together the n particles of two rows, one by one. The rows must not overlap. */
void pullAcross(const ParticleRow& a, const ParticleRow& b, std::size_t n, const Pull& pull);

/** A step of n particles under gravity, before constraints and the surface have their say. */
void moveFreely(float* z, float* before, const float* free, std::size_t n, float keptVelocity,
                float gravityMove);
/** How far a particle that can move has moved at most since the step began [m]. */
float largestMove(const float* z, const float* before, const float* free, std::size_t n);
/** Stops what has passed the surface. */
void stopAt(const float* surface, float* z, float* free, std::size_t n);

}  // namespace mrpt_mapconv::aerial
