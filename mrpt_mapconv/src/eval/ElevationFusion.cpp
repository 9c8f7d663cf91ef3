#include "ElevationFusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "../grid/Wide.h"

namespace mrpt_mapconv::eval
{
namespace
{
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kChunk = 256;         // of a row [cells]
constexpr std::size_t kSlice = kChunk + 2;  // a chunk, and the cells beside it
constexpr float kQuantile = 0.01f;

/** Of a normal distribution with σ of half a cell: mass of the cell at its mean, and of one beside.
 */
struct Masses
{
  float middle, beside;
};
Masses masses()
{
  const auto upTo = [](double cells) { return 0.5 * (1 + std::erf(cells / 0.5 / std::sqrt(2.0))); };
  return {static_cast<float>(upTo(0.5) - upTo(-0.5)), static_cast<float>(upTo(1.5) - upTo(0.5))};
}

/** Some cells of a row, as arrays. What is not known has no weight and is beyond all bounds. */
struct Slice
{
  std::array<float, kSlice> known, height, lower, upper;

  bool hasAny() const
  {
    std::int32_t cells = 0;
    for (const float weight : known) cells += weight > 0 ? 1 : 0;
    return cells > 0;
  }
  /** No cell from `begin` to before `end` is known. */
  void clear(std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      known[i] = height[i] = 0;
      lower[i] = kInfinity;
      upper[i] = -kInfinity;
    }
  }
};

/** Turns cells of a map into such arrays. */
MRPT_MAPCONV_WIDE
void toArrays(const ElevationMap::Cell* cells, std::size_t count, const VarianceLimits limits,
              float* __restrict known, float* __restrict height, float* __restrict lower,
              float* __restrict upper)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const float variance = limits(cells[i].variance), h = cells[i].height;
    const float reach = 2 * std::sqrt(variance);
    const bool isKnown = variance < kInfinity;
    known[i] = isKnown ? 1.0f : 0.0f;
    height[i] = isKnown ? h : 0.0f;
    lower[i] = isKnown ? h - reach : kInfinity;
    upper[i] = isKnown ? h + reach : -kInfinity;
  }
}

// Quantiles are those of the weighted empirical distribution in which the lowest value has
// probability 0, the highest 1, and that is linear in between. No weight of a cell around is so
// small that the 1 % quantile would lie above the second lowest value, or that of 99 % below the
// second highest.

/** Of lower bounds. */
struct LowerQuantile
{
  float first = kInfinity, second = kInfinity, firstWeight = 0, secondWeight = 1;

  void add(float value, float weight)
  {
    const bool isFirst = value < first;
    const float next = isFirst ? first : value, nextWeight = isFirst ? firstWeight : weight;
    secondWeight = next < second ? nextWeight : secondWeight;
    second = next < second ? next : second;
    firstWeight = isFirst ? weight : firstWeight;
    first = isFirst ? value : first;
  }
  float value(float weights) const
  {
    const float share = kQuantile * (weights - firstWeight) / secondWeight;
    return second < kInfinity ? first + share * (second - first) : first;
  }
};

/** Of upper bounds. */
struct UpperQuantile
{
  float last = -kInfinity, beforeLast = -kInfinity, first = kInfinity;
  float lastWeight = 1, firstWeight = 0;

  /** \param value −infinity: there is none */
  void add(float value, float weight)
  {
    const bool isLast = value > last, isFirst = (value < first) & (value > -kInfinity);
    const float before = isLast ? last : value;
    beforeLast = before > beforeLast ? before : beforeLast;
    lastWeight = isLast ? weight : lastWeight;
    last = isLast ? value : last;
    firstWeight = isFirst ? weight : firstWeight;
    first = isFirst ? value : first;
  }
  float value(float weights) const
  {
    const float share = kQuantile * (weights - firstWeight) / lastWeight;
    return beforeLast > -kInfinity ? last - share * (last - beforeLast) : last;
  }
};

MRPT_MAPCONV_WIDE
void fuseChunk(const Slice& below, const Slice& here, const Slice& above, const Masses& mass,
               std::size_t count, float* __restrict height, float* __restrict lower,
               float* __restrict upper)
{
  const float edge = mass.middle * mass.beside, corner = mass.beside * mass.beside;
  for (std::size_t i = 0; i < count; ++i)
  {
    float weights = 0, sum = 0;
    LowerQuantile low;
    UpperQuantile high;
    const auto add = [&](const Slice& row, std::size_t x, float weight)
    {
      weights += weight * row.known[x];
      sum += weight * row.height[x];
      low.add(row.lower[x], weight);
      high.add(row.upper[x], weight);
    };
    add(below, i, corner);
    add(below, i + 1, edge);
    add(below, i + 2, corner);
    add(here, i, edge);
    add(here, i + 1, mass.middle * mass.middle);
    add(here, i + 2, edge);
    add(above, i, corner);
    add(above, i + 1, edge);
    add(above, i + 2, corner);
    const float none = here.known[i + 1] > 0 ? 0.0f : std::numeric_limits<float>::quiet_NaN();
    height[i] = sum / weights + none;
    lower[i] = low.value(weights) + none;
    upper[i] = high.value(weights) + none;
  }
}

/** Walks along a strip of a map, from the lowest row up. */
class Strip
{
 public:
  Strip(const grid::Layer<ElevationMap::Cell>& cells, const VarianceLimits& limits,
        std::int32_t left, std::int32_t width)
      : m_cells(cells), m_limits(limits), m_left(left), m_width(width)
  {
  }

  void fuseAll(FusedElevation& fused, std::int32_t x, std::int32_t y, const Masses& mass)
  {
    const std::int32_t rows = fused.height.frame().height;
    const auto count = static_cast<std::size_t>(m_width);
    load(y - 1, m_slices[0]);
    load(y, m_slices[1]);
    for (std::int32_t iy = 0; iy < rows; ++iy)
    {
      const Slice &below = m_slices[iy % 3], &here = m_slices[(iy + 1) % 3];
      load(y + iy + 1, m_slices[(iy + 2) % 3]);
      float *height = fused.height.row(iy) + x, *lower = fused.lower.row(iy) + x,
            *upper = fused.upper.row(iy) + x;
      if (here.hasAny())
        fuseChunk(below, here, m_slices[(iy + 2) % 3], mass, count, height, lower, upper);
      else
        for (float* layer : {height, lower, upper})
          std::fill_n(layer, count, std::numeric_limits<float>::quiet_NaN());
    }
  }

 private:
  /** \param iy row of the map, or one beside it */
  void load(std::int32_t iy, Slice& slice) const
  {
    const grid::GridFrame& frame = m_cells.frame();
    if (iy < 0 || iy >= frame.height) return slice.clear(0, kSlice);
    const std::int32_t left = std::max(m_left - 1, 0);
    const std::int32_t right = std::min(m_left + m_width + 1, frame.width);
    const auto begin = static_cast<std::size_t>(left - (m_left - 1));
    const auto count = static_cast<std::size_t>(right - left);
    slice.clear(0, begin);
    toArrays(m_cells.row(iy) + left, count, m_limits, slice.known.data() + begin,
             slice.height.data() + begin, slice.lower.data() + begin, slice.upper.data() + begin);
    slice.clear(begin + count, kSlice);
  }

  const grid::Layer<ElevationMap::Cell>& m_cells;
  const VarianceLimits m_limits;
  const std::int32_t m_left, m_width;
  std::array<Slice, 3> m_slices;
};
}  // namespace

void fuseElevation(const grid::Layer<ElevationMap::Cell>& cells, const VarianceLimits& limits,
                   FusedElevation& fused)
{
  const grid::GridFrame &from = cells.frame(), &to = fused.height.frame();
  const Masses mass = masses();
  constexpr auto kWidth = static_cast<std::int32_t>(kChunk);
  for (std::int32_t x = 0; x < to.width; x += kWidth)
    Strip(cells, limits, to.x0 - from.x0 + x, std::min(kWidth, to.width - x))
        .fuseAll(fused, x, to.y0 - from.y0, mass);
}

}  // namespace mrpt_mapconv::eval
