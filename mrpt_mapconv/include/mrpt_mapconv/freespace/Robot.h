#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mrpt_mapconv::freespace
{
/** For which robot a map or a path is meant. */
enum class Robot : std::uint8_t
{
  Ground,
  Aerial
};

/** How files call the robots, in the order of the enumeration. */
inline const std::vector<std::string>& namesOf(Robot)
{
  static const std::vector<std::string> names{"ground", "aerial"};
  return names;
}

}  // namespace mrpt_mapconv::freespace
