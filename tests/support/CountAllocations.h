#pragma once

#include <cstddef>
#include <functional>

namespace mrpt_mapconv::fixtures
{
/** How many blocks of memory a call takes from operator new. Not for threads. */
std::size_t allocationsOf(const std::function<void()>& call);

}  // namespace mrpt_mapconv::fixtures
