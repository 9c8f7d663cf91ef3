#pragma once

#include <exception>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>

namespace mrpt_mapconv::params
{
/** Complains about a parameter, in the words that all of them share.
 * \param right what would be, e.g. "a range > 0 m"
 * \exception std::invalid_argument "NAME = VALUE is not valid: it must be RIGHT", unless ok */
template <class Value, class Text>
void require(bool ok, const char* name, Value value, const Text& right)
{
  if (ok) return;
  std::ostringstream message;
  message.imbue(std::locale::classic());
  message << name << " = " << value << " is not valid: it must be " << right;
  throw std::invalid_argument(message.str());
}

/** What an exception says, in one line that can be shown: MRPT's own come with a frame, a location
 * and a call stack, which are of use to MRPT's developers only. */
std::string oneLine(const std::exception& error);

}  // namespace mrpt_mapconv::params
