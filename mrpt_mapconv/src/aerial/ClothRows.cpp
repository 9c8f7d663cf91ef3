#include "ClothRows.h"

#include <algorithm>
#include <cmath>

#include "../grid/Wide.h"

namespace mrpt_mapconv::aerial
{
namespace
{
constexpr double kPull = 0.3;  // of a pass
}

Pull Pull::ofPasses(int passes)
{
  return {static_cast<float>((1 - std::pow(1 - 2 * kPull, passes)) / 2),
          static_cast<float>(1 - std::pow(1 - kPull, passes))};
}

MRPT_MAPCONV_WIDE
void pullAlong(const ParticleRow& row, std::size_t n, std::size_t step, const Pull& pull,
               float* before)
{
  if (n <= step) return;
  float* __restrict z = row.z;
  const float* __restrict w = row.free;
  float* __restrict old = before;
  const float one = pull.oneFree, less = pull.bothFree - pull.oneFree;
  for (std::size_t i = 0; i < n; ++i) old[i] = z[i];
  for (std::size_t i = 0; i + step < n; ++i)
    z[i] += w[i] * (one + less * w[i + step]) * (old[i + step] - old[i]);
  for (std::size_t i = step; i < n; ++i)
    z[i] += w[i] * (one + less * w[i - step]) * (old[i - step] - old[i]);
}

MRPT_MAPCONV_WIDE
void pullAcross(const ParticleRow& a, const ParticleRow& b, std::size_t n, const Pull& pull)
{
  float* __restrict za = a.z;
  float* __restrict zb = b.z;
  const float* __restrict wa = a.free;
  const float* __restrict wb = b.free;
  const float one = pull.oneFree, less = pull.bothFree - pull.oneFree;
  for (std::size_t i = 0; i < n; ++i)
  {
    const float difference = zb[i] - za[i];
    za[i] += wa[i] * (one + less * wb[i]) * difference;
    zb[i] -= wb[i] * (one + less * wa[i]) * difference;
  }
}

MRPT_MAPCONV_WIDE
void moveFreely(float* __restrict z, float* __restrict before, const float* __restrict free,
                std::size_t n, float keptVelocity, float gravityMove)
{
  for (std::size_t i = 0; i < n; ++i)
  {
    const float move = (z[i] - before[i]) * keptVelocity + gravityMove;
    before[i] = z[i];
    z[i] += free[i] * move;
  }
}

MRPT_MAPCONV_WIDE
float largestMove(const float* __restrict z, const float* __restrict before,
                  const float* __restrict free, std::size_t n)
{
  float largest = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const float move = free[i] * std::abs(z[i] - before[i]);
    largest = move > largest ? move : largest;
  }
  return largest;
}

MRPT_MAPCONV_WIDE
void stopAt(const float* __restrict surface, float* __restrict z, float* __restrict free,
            std::size_t n)
{
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool meets = z[i] > surface[i];
    z[i] = meets ? surface[i] : z[i];
    free[i] = meets ? 0.0F : free[i];
  }
}

}  // namespace mrpt_mapconv::aerial
