#pragma once

#include <mrpt_mapconv/aerial/GroundParams.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <cstdint>
#include <vector>

#include "ClothRows.h"
#include "MeanSlope.h"

namespace mrpt_mapconv::aerial
{
/** A cloth of particles, one at each cell's centre, that gravity presses against a surface from
 * below (Zhang et al. 2016 turn the cloud over instead, which is the same). It spans what rises
 * steeply, and follows what rises slowly.
 *
 * Particles move up and down only, and stay for ever where they meet the surface. Each is held by
 * its neighbours at one and two cells in eight directions; a pass moves both ends of such a
 * constraint by 0.3 of their difference, or the free one of them, and all `rigidness` passes are
 * made at once, as in the published code, where each constraint also has its turn twice a step.
 *
 * Constraints are worked on row by row, upwards. The second turn follows the first through the
 * cloth at a distance, so two threads give what one would. (Strips of rows side by side are faster
 * on more threads, but leave creases where they meet.) */
class Cloth
{
 public:
  /** Lies just below the surface, as steep as that is on the whole. \param surface heights without
   * gaps [m] */
  Cloth(grid::Layer<float> surface, const GroundParams& params, int threads);

  /** Starts from rest and moves until it rests or maxIterations are done.
   * \return the number of steps */
  std::int32_t settle();

  /** Whether the particle of a cell has met the surface. */
  bool isFixed(std::size_t cell) const { return m_free[cell] == 0; }
  /** How far a particle is below the surface [m]. */
  float gap(std::size_t cell) const { return m_surface[cell] - m_z[cell]; }
  /** Moves a particle to the surface, where it stays. */
  void fix(std::size_t cell);
  /** The particles' heights [m]. */
  grid::Layer<float> heights() const;

 private:
  void moveByGravity();
  void pullTogether();
  void pullRow(std::size_t y, const Pull& pull, std::vector<float>& scratch);
  ParticleRow particles(std::size_t x, std::size_t y);  // from there on to the right
  /** \return how far a particle has moved at most, before it was stopped [m] */
  float stopAtSurface();

  grid::GridFrame m_frame;
  GroundParams m_params;
  int m_threads;
  MeanSlope m_slope;                            // the heights below are without it
  float m_base = 0;                             // what they are relative to [m]
  std::vector<float> m_surface, m_z, m_before;  // of each particle [m]; m_before: a step ago
  std::vector<float> m_free;                    // 1 for particles that can move, else 0
};

}  // namespace mrpt_mapconv::aerial
