#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace mrpt_mapconv::params
{
/** What a map or cloud may take [bytes]: three quarters of what the machine has, or its container
 * may use. */
std::size_t memoryLimit();
/** \param maxMemory what was asked for [MB]; none: the same
 * \exception std::invalid_argument unless it is above 0 */
std::size_t memoryLimit(const std::optional<std::int32_t>& maxMemory);

constexpr double kMegabyte = 1e6;  //!< [bytes]

}  // namespace mrpt_mapconv::params
