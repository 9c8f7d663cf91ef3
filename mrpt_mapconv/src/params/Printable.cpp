#include <mrpt_mapconv/params/Printable.h>

#include <array>

namespace mrpt_mapconv::params
{
namespace
{
unsigned char byteAt(std::string_view text, std::size_t i)
{
  return static_cast<unsigned char>(text[i]);
}

std::string hexadecimal(std::string_view bytes)
{
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    text += {'\\', 'x', digits[byteAt(bytes, i) >> 4], digits[byteAt(bytes, i) & 15]};
  return text;
}

bool isBlank(char c) { return c == '\n' || c == '\r' || c == '\t'; }
}  // namespace

std::size_t utf8Length(std::string_view text)
{
  if (text.empty()) return 0;
  const unsigned char first = byteAt(text, 0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byteAt(text, i) & 0xC0) != 0x80) return 0;
  // overlong forms, surrogates and what lies beyond Unicode
  if (first == 0xE0 && byteAt(text, 1) < 0xA0) return 0;
  if (first == 0xED && byteAt(text, 1) > 0x9F) return 0;
  if (first == 0xF0 && byteAt(text, 1) < 0x90) return 0;
  if (first == 0xF4 && byteAt(text, 1) > 0x8F) return 0;
  return length;
}

char32_t codePointOf(std::string_view character)
{
  constexpr std::array<unsigned, 5> bitsOfFirst = {0, 0x7F, 0x1F, 0x0F, 0x07};
  char32_t code = byteAt(character, 0) & bitsOfFirst[character.size()];
  for (std::size_t i = 1; i < character.size(); ++i)
    code = code << 6 | (byteAt(character, i) & 0x3Fu);
  return code;
}

bool isShown(char32_t c)
{
  const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
  const bool control = c < 0x20 || within(0x7F, 0x9F);
  const bool direction = within(0x200E, 0x200F) || within(0x202A, 0x202E) || within(0x2066, 0x2069);
  const bool lineEnd = within(0x2028, 0x2029);
  constexpr char32_t byteOrderMark = 0xFEFF;
  return !control && !direction && !lineEnd && c != byteOrderMark;
}

std::string printable(std::string_view text, std::size_t longest)
{
  std::string shown;
  for (std::size_t used = 0; !text.empty();)
  {
    const std::size_t length = utf8Length(text);
    const auto character = text.substr(0, length == 0 ? 1 : length);
    used += character.size();
    if (used > longest) return shown + "...";
    if (length == 1 && isBlank(text.front()))
      shown += ' ';
    else if (length > 0 && isShown(codePointOf(character)))
      shown += character;
    else
      shown += hexadecimal(character);
    text.remove_prefix(character.size());
  }
  return shown;
}

}  // namespace mrpt_mapconv::params
