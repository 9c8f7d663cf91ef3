#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace mrpt_mapconv::params
{
namespace
{
std::string withoutClosingZeros(std::string decimals)
{
  decimals.erase(decimals.find_last_not_of('0') + 1);
  if (decimals.back() == '.') decimals.pop_back();
  return decimals == "-0" ? "0" : decimals;
}
}  // namespace

std::string roundedText(double value)
{
  if (std::abs(value) < 1e6) return placeText(value);
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4)
          .ptr;
  return {text.data(), end};
}

std::string placeText(double metres)
{
  std::array<char, 400> text{};  // the longest doubles have some 310 digits
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), metres, std::chars_format::fixed, 3)
          .ptr;
  return std::isfinite(metres) ? withoutClosingZeros({text.data(), end})
                               : std::string(text.data(), end);
}

std::string withoutByteOrderMark(std::string text)
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.compare(0, mark.size(), mark) == 0) text.erase(0, mark.size());
  return text;
}

std::string trimmed(std::string_view text)
{
  constexpr std::string_view blanks = " \t\r";
  const auto begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(blanks) + 1 - begin));
}

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string alternatives(const std::vector<std::string>& names)
{
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : " or ") + name;
  return text;
}

std::string counted(std::size_t count, std::string_view noun)
{
  return std::to_string(count).append(" ").append(noun).append(count == 1 ? "" : "s");
}

}  // namespace mrpt_mapconv::params
