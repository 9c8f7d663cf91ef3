#pragma once

#include <cstdint>

namespace mrpt_mapconv::freespace
{
/** For which robot a map or a path is meant. */
enum class Robot : std::uint8_t
{
  Ground,
  Aerial
};

}  // namespace mrpt_mapconv::freespace
