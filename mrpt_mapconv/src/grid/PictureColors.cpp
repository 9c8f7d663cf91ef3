#include <mrpt_mapconv/grid/PictureColors.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mrpt_mapconv::grid::picture
{
namespace
{
template <std::size_t N>
TColor interpolate(const std::array<TColor, N>& anchors, double t)
{
  const double place = std::clamp(t, 0.0, 1.0) * (N - 1);
  const auto i = std::min(static_cast<std::size_t>(place), N - 2);
  const double share = place - static_cast<double>(i);
  const auto mix = [share](std::uint8_t a, std::uint8_t b)
  { return static_cast<std::uint8_t>(std::lround(a + share * (b - a))); };
  const TColor &a = anchors[i], &b = anchors[i + 1];
  return {mix(a.R, b.R), mix(a.G, b.G), mix(a.B, b.B)};
}

std::vector<float> finiteValues(const Layer<float>& layer)
{
  std::vector<float> values;
  values.reserve(layer.cells().size());
  for (const float value : layer.cells())
    if (std::isfinite(value)) values.push_back(value);
  return values;
}

double percentile(std::vector<float>& values, double share)
{
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return static_cast<double>(values[static_cast<std::size_t>(rank)]);
}

/** Outliers are clipped only if the colours gain a quarter of their span by it. */
bool worthClipping(double robustSpan, double fullSpan) { return fullSpan > 1.25 * robustSpan; }

ColorRange dataRange(const std::vector<float>& values)
{
  ColorRange range;
  if (values.empty()) return range;
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  range.empty = false;
  range.low = range.dataMin = static_cast<double>(*min);
  range.high = range.dataMax = static_cast<double>(*max);
  return range;
}
}  // namespace

TColor heightColor(double t)
{
  static const std::array<TColor, 9> anchors = {{{68, 1, 84},
                                                 {71, 44, 122},
                                                 {59, 81, 139},
                                                 {44, 113, 142},
                                                 {33, 144, 141},
                                                 {39, 173, 129},
                                                 {92, 200, 99},
                                                 {170, 220, 50},
                                                 {253, 231, 37}}};
  return interpolate(anchors, t);
}

TColor slopeColor(double t)
{
  static const std::array<TColor, 6> anchors = {{{255, 255, 212},
                                                 {254, 217, 118},
                                                 {253, 160, 70},
                                                 {240, 75, 40},
                                                 {189, 10, 38},
                                                 {92, 0, 32}}};
  return interpolate(anchors, t);
}

ColorRange heightRange(const Layer<float>& layer)
{
  std::vector<float> values = finiteValues(layer);
  ColorRange range = dataRange(values);
  if (range.empty) return range;
  // few cells may matter: a table's top is 2 % of a building's floor
  const double low = percentile(values, 0.005), high = percentile(values, 0.995);
  if (high > low && worthClipping(high - low, range.high - range.low))
  {
    range.low = low;
    range.high = high;
  }
  constexpr double kLeastSpan = 0.01;  // else rounding noise on a level floor fills all colours
  if (range.high - range.low < kLeastSpan)
  {
    range.low -= 0.5;
    range.high += 0.5;
  }
  return range;
}

ColorRange slopeRange(const Layer<float>& layer)
{
  std::vector<float> values = finiteValues(layer);
  ColorRange range = dataRange(values);
  if (range.empty) return range;
  range.low = std::min(0.0, range.dataMin);
  const double high = percentile(values, 0.98);
  if (high > 0 && worthClipping(high, range.high)) range.high = high;
  constexpr double kLeastSpan = 0.01;
  if (range.high - range.low < kLeastSpan) range.high = range.low + 1;
  return range;
}

}  // namespace mrpt_mapconv::grid::picture
