#pragma once

#include <sstream>
#include <stdexcept>

namespace mrpt_mapconv::grid
{
/** Complains about a parameter, in the words that all of them share.
 * \param right what would be, e.g. "a range > 0 m"
 * \exception std::invalid_argument "NAME = VALUE is not valid: it must be RIGHT", unless ok */
template <class Value, class Text>
void require(bool ok, const char* name, Value value, const Text& right)
{
  if (ok) return;
  std::ostringstream message;
  message << name << " = " << value << " is not valid: it must be " << right;
  throw std::invalid_argument(message.str());
}

}  // namespace mrpt_mapconv::grid
