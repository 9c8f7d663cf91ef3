#include <mrpt_mapconv/observation/PoseCovariance.h>

#include <array>
#include <cmath>

namespace mrpt_mapconv::observation
{
std::optional<HeightCovariance> heightCovariance(const mrpt::math::CMatrixDouble66& pose)
{
  constexpr std::array<int, 3> kZRollPitch{2, 5, 4};
  HeightCovariance out;
  bool isKnown = false;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
    {
      const double value = pose(kZRollPitch.at(static_cast<std::size_t>(row)),
                                kZRollPitch.at(static_cast<std::size_t>(column)));
      if (!std::isfinite(value) || (row == column && value < 0)) return std::nullopt;
      isKnown |= value != 0;
      out(row, column) = value;
    }
  if (!isKnown) return std::nullopt;
  return out;
}

}  // namespace mrpt_mapconv::observation
