#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

namespace mrpt_mapconv::params
{
/** What stands for an optional number that is not there. */
constexpr const char* kAuto = "auto";

/** The shortest text that reads back as the same number, whatever the locale. */
template <class Number>
std::string shortestText(Number value)
{
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/** The same without an exponent, which YAML 1.1 takes for a string unless it is written in just one
 * of its ways ("1.0e-04"). */
inline std::string decimalText(double value)
{
  std::array<char, 400> text{};  // the longest doubles have some 330 digits
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
  return {text.data(), end};
}

/** A measured or computed number for messages: three decimals at most, none that say nothing; from
 * a million on four digits. */
std::string roundedText(double value);
/** A coordinate for messages, which may be of a national grid: millimetres at any size. */
std::string placeText(double metres);

/** Reads a text that is a number from its first to its last character, whatever the locale.
 * \return false, and the number as it was, for any other text */
template <class Number>
bool readWhole(std::string_view text, Number& number)
{
  Number read{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), read);
  if (error != std::errc() || stop != text.data() + text.size()) return false;
  number = read;
  return true;
}

/** ASCII letters made small. */
std::string lowerCase(std::string text);

/** Reads a finite number as people write it: there may be a plus before it. \return as readWhole()
 */
template <class Number>
bool readNumber(std::string_view text, Number& number)
{
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number read{};
  if (!readWhole(text, read)) return false;
  if constexpr (std::is_floating_point_v<Number>)
    if (!std::isfinite(read)) return false;
  number = read;
  return true;
}

/** The same, or auto, in whatever capitals, for none. */
template <class Number>
bool readNumberOrAuto(const std::string& text, std::optional<Number>& number)
{
  Number read{};
  if (lowerCase(text) == kAuto)
    number.reset();
  else if (readNumber(text, read))
    number = read;
  else
    return false;
  return true;
}

/** Without the byte order mark that some editors begin UTF-8 with. */
std::string withoutByteOrderMark(std::string text);
/** Without the blanks, tabs and carriage returns around it. */
std::string trimmed(std::string_view text);
/** "red or green". */
std::string alternatives(const std::vector<std::string>& names);
/** "1 scan", "2 scans". \param noun in the singular, one that takes an s */
std::string counted(std::size_t count, std::string_view noun);

}  // namespace mrpt_mapconv::params
