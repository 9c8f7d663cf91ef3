#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace mrpt_mapconv::params
{
/** Number of bytes of the UTF-8 character at the start of a text; 0 if there is none. */
std::size_t utf8Length(std::string_view text);

/** The code point of a character that is valid UTF-8 and nothing else. */
char32_t codePointOf(std::string_view character);

/** Whether a terminal shows that character and does nothing else: control characters (also those
 * of 8 bits), marks of direction and byte order marks are none. */
bool isShown(char32_t codePoint);

/** What can be shown of a text that may hold anything, in one line: what is no character or would
 * not be shown stands there as \xNN, line ends and tabs as blanks.
 * \param longest bytes of the text, the rest of which becomes "..." */
std::string printable(std::string_view text,
                      std::size_t longest = std::numeric_limits<std::size_t>::max());

}  // namespace mrpt_mapconv::params
