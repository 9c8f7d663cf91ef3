#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace mrpt_mapconv::params
{
std::string roundedText(double value)
{
  const bool plain = std::abs(value) < 1e6;
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value,
                    plain ? std::chars_format::fixed : std::chars_format::general, plain ? 3 : 4)
          .ptr;
  std::string rounded(text.data(), end);
  if (!plain) return rounded;
  rounded.erase(rounded.find_last_not_of('0') + 1);
  if (rounded.back() == '.') rounded.pop_back();
  return rounded == "-0" ? "0" : rounded;
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
