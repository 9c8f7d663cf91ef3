#include "output/Json.h"

#include <mrpt_mapconv/params/Text.h>

#include <cmath>
#include <cstdio>

namespace mapconv
{
namespace
{
unsigned char byteAt(std::string_view text, std::size_t i)
{
  return static_cast<unsigned char>(text[i]);
}

/** Number of bytes of the UTF-8 character at the start of `text`; 0 if it is none. */
std::size_t utf8Length(std::string_view text)
{
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

std::string escaped(char c)
{
  if (c == '"' || c == '\\') return std::string("\\") + c;
  if (c == '\n') return "\\n";
  if (c == '\t') return "\\t";
  std::array<char, 8> code{};
  std::snprintf(code.data(), code.size(), "\\u%04x", static_cast<unsigned>(c));
  return code.data();
}
}  // namespace

std::string jsonString(std::string_view text)
{
  std::string out = "\"";
  while (!text.empty())
  {
    const std::size_t length = utf8Length(text);
    const char c = text.front();
    if (length == 0)
      out += "\xEF\xBF\xBD";
    else if (length == 1 && (c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20))
      out += escaped(c);
    else
      out += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out + "\"";
}

std::string jsonNumber(double value)
{
  if (!std::isfinite(value)) return "null";
  return mrpt_mapconv::params::shortestText(value);
}

JsonObject& JsonObject::add(const std::string& key, const std::vector<std::string>& values)
{
  std::string list;
  for (const auto& value : values) list += (list.empty() ? "" : ", ") + jsonString(value);
  return addRaw(key, "[" + list + "]");
}

JsonObject& JsonObject::addRaw(const std::string& key, const std::string& value)
{
  m_members += (m_members.empty() ? "" : ", ") + jsonString(key) + ": " + value;
  return *this;
}

}  // namespace mapconv
