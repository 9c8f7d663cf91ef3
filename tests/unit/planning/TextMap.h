#pragma once

#include <mrpt_mapconv/grid/Layer.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::test
{
/** An occupancy layer of 0.1 m cells with its corner at the origin, drawn with the highest y first:
 * '.' free, '#' occupied, '?' unknown. */
inline grid::Layer<float> textMap(const std::vector<std::string>& rows)
{
  const auto width = static_cast<std::int32_t>(rows.front().size());
  const auto height = static_cast<std::int32_t>(rows.size());
  grid::Layer<float> map({0.1, 0, 0, width, height}, -1.0f);
  for (std::int32_t iy = 0; iy < height; ++iy)
    for (std::int32_t ix = 0; ix < width; ++ix)
    {
      const char c =
          rows.at(static_cast<std::size_t>(height - 1 - iy)).at(static_cast<std::size_t>(ix));
      map.at(ix, iy) = c == '.' ? 0.0f : c == '#' ? 1.0f : -1.0f;
    }
  return map;
}

}  // namespace mrpt_mapconv::test
