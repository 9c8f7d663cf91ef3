#include "Cloth.h"

#include <algorithm>
#include <utility>

#include "../grid/Parallel.h"

namespace mrpt_mapconv::aerial
{
namespace
{
constexpr float kStartBelow = 0.05F;           // the lowest cell of the surface [m]
constexpr std::size_t kFewParticles = 131072;  // whose steps are shorter than waking threads
constexpr std::size_t kTurnsOfAStep = 2;       // of each constraint
constexpr std::size_t kStripRows = 64;         // at least 2, the reach of a constraint
}  // namespace

Cloth::Cloth(grid::Layer<float> surface, const GroundParams& params, int threads)
    : m_frame(surface.frame()),
      m_params(params),
      m_threads(m_frame.size() < kFewParticles ? 1 : threads),
      m_slope(MeanSlope::of(surface)),
      m_z(m_frame.size(), -kStartBelow),
      m_before(m_z),
      m_free(m_z.size(), 1)
{
  tilt(surface, -m_slope);
  m_surface = std::move(surface.cells());
  m_base = *std::min_element(m_surface.begin(), m_surface.end());
  for (float& height : m_surface) height -= m_base;
}

std::int32_t Cloth::settle()
{
  m_before = m_z;
  for (std::int32_t step = 1; step <= m_params.maxIterations; ++step)
  {
    moveByGravity();
    pullTogether();
    if (stopAtSurface() < static_cast<float>(m_params.restMove)) return step;
  }
  return m_params.maxIterations;
}

void Cloth::moveByGravity()
{
  const auto velocity = static_cast<float>(1 - m_params.damping);
  const auto gravity = static_cast<float>(m_params.firstMove());
  const auto width = static_cast<std::size_t>(m_frame.width);
  grid::inParallel(static_cast<std::size_t>(m_frame.height), m_threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     const std::size_t at = begin * width;
                     moveFreely(&m_z[at], &m_before[at], &m_free[at], (end - begin) * width,
                                velocity, gravity);
                   });
}

float Cloth::stopAtSurface()
{
  const auto width = static_cast<std::size_t>(m_frame.width);
  std::vector<float> moves(static_cast<std::size_t>(m_frame.height));
  grid::inParallel(moves.size(), m_threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     for (std::size_t y = begin; y < end; ++y)
                     {
                       const std::size_t at = y * width;
                       moves[y] = largestMove(&m_z[at], &m_before[at], &m_free[at], width);
                       stopAt(&m_surface[at], &m_z[at], &m_free[at], width);
                     }
                   });
  return *std::max_element(moves.begin(), moves.end());
}

void Cloth::pullTogether()
{
  const Pull pull = Pull::ofPasses(m_params.rigidness);
  const auto rows = static_cast<std::size_t>(m_frame.height);
  const std::size_t strips = (rows + kStripRows - 1) / kStripRows;
  const auto pullStrip = [&](std::size_t strip)
  {
    std::vector<float> scratch(static_cast<std::size_t>(m_frame.width));
    const std::size_t first = strip * kStripRows;
    for (std::size_t y = first; y < std::min(first + kStripRows, rows); ++y)
      pullRow(y, pull, scratch);
  };
  // turns follow each other through the strips at a distance at which they share no row
  constexpr std::size_t kLag = 2;
  for (std::size_t at = 0; at < strips + (kTurnsOfAStep - 1) * kLag; ++at)
    grid::inParallel(kTurnsOfAStep, m_threads,
                     [&](std::size_t begin, std::size_t end)
                     {
                       for (std::size_t turn = begin; turn < end; ++turn)
                         if (at >= turn * kLag && at - turn * kLag < strips)
                           pullStrip(at - turn * kLag);
                     });
}

void Cloth::pullRow(std::size_t y, const Pull& pull, std::vector<float>& scratch)
{
  const auto width = static_cast<std::size_t>(m_frame.width);
  for (const std::size_t reach : {1U, 2U})
  {
    pullAlong(particles(0, y), width, reach, pull, scratch.data());
    const std::size_t other = y + reach;
    if (other >= static_cast<std::size_t>(m_frame.height)) continue;
    pullAcross(particles(0, y), particles(0, other), width, pull);
    if (width <= reach) continue;
    pullAcross(particles(0, y), particles(reach, other), width - reach, pull);
    pullAcross(particles(reach, y), particles(0, other), width - reach, pull);
  }
}

ParticleRow Cloth::particles(std::size_t x, std::size_t y)
{
  const std::size_t at = y * static_cast<std::size_t>(m_frame.width) + x;
  return {&m_z[at], &m_free[at]};
}

void Cloth::fix(std::size_t cell)
{
  m_z[cell] = m_surface[cell];
  m_free[cell] = 0;
}

grid::Layer<float> Cloth::heights() const
{
  grid::Layer<float> heights(m_frame, 0);
  for (std::size_t i = 0; i < m_z.size(); ++i) heights.cells()[i] = m_z[i] + m_base;
  tilt(heights, m_slope);
  return heights;
}

}  // namespace mrpt_mapconv::aerial
