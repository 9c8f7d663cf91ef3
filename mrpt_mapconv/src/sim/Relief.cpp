#include "Relief.h"

#include <cmath>

#include "Noise.h"
#include "SectionKeys.h"

namespace mrpt_mapconv::sim
{
namespace
{
constexpr double kNoiseCell = 0.001;  // of the noise's whole numbers [m]
constexpr double kShortest = 0.01;    // wavelength [m]
constexpr std::int32_t kMostOctaves = 12;

std::int32_t toNoiseCells(double metres)
{
  return static_cast<std::int32_t>(std::lround(metres / kNoiseCell));
}
}  // namespace

Relief Relief::read(params::StrictSection& section)
{
  Relief relief;
  if (section.has("base")) relief.base = readNumber(section, "base");
  if (section.has("gradient")) relief.gradient = readPoint2D(section, "gradient");
  if (section.has("amplitude"))
  {
    relief.amplitude = readNumber(section, "amplitude");
    if (relief.amplitude < 0) section.fail("amplitude", "a height >= 0 [m]");
  }
  if (section.has("wavelength") || relief.amplitude > 0)
    relief.wavelength = readPositive(section, "wavelength");
  section.read("octaves", relief.octaves);
  if (relief.octaves < 1 || relief.octaves > kMostOctaves)
    section.fail("octaves", "within 1 and 12");
  if (std::ldexp(relief.wavelength, 1 - relief.octaves) < kShortest)
    section.fail("wavelength", "such that the last octave's is at least 0.01 m");
  section.read("seed", relief.seed);
  return relief;
}

double Relief::heightAt(double x, double y) const
{
  double height = base + gradient.x * x + gradient.y * y;
  if (amplitude == 0) return height;
  for (std::int32_t octave = 0; octave < octaves; ++octave)
  {
    const double share = std::ldexp(1.0, -octave);
    const ValueNoise noise(seed + static_cast<std::uint64_t>(octave),
                           toNoiseCells(wavelength * share));
    const auto value = static_cast<double>(noise(toNoiseCells(x), toNoiseCells(y)));
    height += amplitude * share * (2 * value / ValueNoise::kOne - 1);
  }
  return height;
}

}  // namespace mrpt_mapconv::sim
