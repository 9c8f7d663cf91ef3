#include "output/Json.h"

#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/params/Text.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace mapconv
{
namespace params = mrpt_mapconv::params;

namespace
{
/** As JSON's escape; all that has to be one lies in Unicode's first plane. */
std::string escaped(char32_t c)
{
  if (c == '"') return "\\\"";
  if (c == '\\') return "\\\\";
  if (c == '\n') return "\\n";
  if (c == '\t') return "\\t";
  std::array<char, 8> code{};
  std::snprintf(code.data(), code.size(), "\\u%04x", static_cast<unsigned>(c & 0xFFFF));
  return code.data();
}
}  // namespace

std::string jsonString(std::string_view text)
{
  std::string out = "\"";
  while (!text.empty())
  {
    const std::size_t length = params::utf8Length(text);
    const auto character = text.substr(0, length == 0 ? 1 : length);
    text.remove_prefix(character.size());
    if (length == 0)
    {
      out += "\xEF\xBF\xBD";
      continue;
    }
    const char32_t code = params::codePointOf(character);
    if (code == '"' || code == '\\' || !params::isShown(code))
      out += escaped(code);
    else
      out += character;
  }
  return out + "\"";
}

std::string jsonNumber(double value)
{
  if (!std::isfinite(value)) return "null";
  return params::shortestText(value);
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
