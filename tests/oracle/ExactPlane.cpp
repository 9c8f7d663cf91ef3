#include "ExactPlane.h"

#include <cmath>

#include "DenseOracle.h"

namespace mrpt_mapconv::oracle
{
namespace
{
// 128 bits hold every product of moments of a 201×201 window with floors up to 2^16 voxels apart,
// in 64ths of voxels.
__extension__ typedef __int128 Exact;

Exact magnitude(Exact value) { return value < 0 ? -value : value; }

/** A plane's slope as sqrt(a² + b²)/d with exact integers. */
struct ExactSlope
{
  Exact a = 0, b = 0, d = 0;  //!< d = 0: no plane
};

/** Cells and heights are counted from the centre, in cells and in the heights' unit. */
ExactSlope slopeOf(int window, const HeightAt& heightAt, std::int64_t centre)
{
  Exact n = 0, sx = 0, sy = 0, sz = 0, sxx = 0, sxy = 0, syy = 0, sxz = 0, syz = 0;
  for (int dy = -window; dy <= window; ++dy)
    for (int dx = -window; dx <= window; ++dx)
    {
      const std::optional<std::int64_t> height = heightAt(dx, dy);
      if (!height) continue;
      const Exact x = dx, y = dy, z = *height - centre;
      n += 1;
      sx += x, sy += y, sz += z;
      sxx += x * x, sxy += x * y, syy += y * y;
      sxz += x * z, syz += y * z;
    }
  const Exact xx = n * sxx - sx * sx, xy = n * sxy - sx * sy, yy = n * syy - sy * sy;
  const Exact xz = n * sxz - sx * sz, yz = n * syz - sy * sz;
  // fewer than three cells always lie on one line, and there the determinant is exactly 0
  return {xz * yy - yz * xy, yz * xx - xz * xy, xx * yy - xy * xy};
}

}  // namespace

void fitPlane(int window, const HeightAt& heightAt, int unitsPerVoxel, double maxSlope, Cell& cell)
{
  constexpr Exact kExactInDouble = static_cast<Exact>(1) << 53;
  const std::optional<std::int64_t> centre = heightAt(0, 0);
  if (!centre) return;
  const ExactSlope s = slopeOf(window, heightAt, *centre);
  cell.hasSlope = s.d != 0;
  if (!cell.hasSlope) return;

  // cells and voxels have the same size, so this is in metres per metre
  const Exact run = s.d * unitsPerVoxel;
  const auto a = static_cast<long double>(s.a), b = static_cast<long double>(s.b);
  cell.slope = std::hypot(a, b) / static_cast<long double>(run);
  // A plane along an axis is one division of exact integers, so even a tie is certain in double.
  const Exact rise = magnitude(s.a) + magnitude(s.b);
  const bool axisAligned = (s.a == 0 || s.b == 0) && rise < kExactInDouble && run < kExactInDouble;
  if (axisAligned) cell.slope = static_cast<double>(rise) / static_cast<double>(run);
  cell.slopeTooHigh = cell.slope > maxSlope;
  cell.slopeTie = !axisAligned && std::abs(cell.slope - maxSlope) <= 1e-12L * maxSlope;
}

}  // namespace mrpt_mapconv::oracle
