#pragma once

#include <stdexcept>

namespace mapconv
{
/** Options that are wrong in a way that only shows when they are seen together: exit status 2. */
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

}  // namespace mapconv
