#include "StrictJson.h"

#include <cstdlib>
#include <cstring>
#include <regex>
#include <stdexcept>

namespace mrpt_mapconv::testing
{
namespace
{
class Parser
{
 public:
  explicit Parser(const std::string& text) : m_text(text) {}

  JsonValue whole()
  {
    JsonValue result = value();
    skipSpace();
    if (m_at != m_text.size()) fail("text behind the value");
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw std::runtime_error("JSON: " + what + " at byte " + std::to_string(m_at) + " of " +
                             m_text);
  }
  void skipSpace()
  {
    while (m_at < m_text.size() && std::strchr(" \t\r\n", m_text[m_at])) ++m_at;
  }
  char peek()
  {
    skipSpace();
    if (m_at >= m_text.size()) fail("end of text");
    return m_text[m_at];
  }
  bool take(char c)
  {
    if (peek() != c) return false;
    ++m_at;
    return true;
  }
  void want(char c)
  {
    if (!take(c)) fail(std::string("no '") + c + "'");
  }

  JsonValue value()
  {
    switch (peek())
    {
      case '{':
        return object();
      case '[':
        return list();
      case '"':
        return text();
      default:
        return word();
    }
  }

  JsonValue object()
  {
    JsonValue result;
    result.kind = JsonValue::Kind::Object;
    want('{');
    if (take('}')) return result;
    do
    {
      if (peek() != '"') fail("a key that is no string");
      const std::string key = text().text;
      want(':');
      if (!result.object.emplace(key, value()).second) fail("the key '" + key + "' twice");
    } while (take(','));
    want('}');
    return result;
  }

  JsonValue list()
  {
    JsonValue result;
    result.kind = JsonValue::Kind::List;
    want('[');
    if (take(']')) return result;
    do result.list.push_back(value());
    while (take(','));
    want(']');
    return result;
  }

  JsonValue text()
  {
    JsonValue result;
    result.kind = JsonValue::Kind::Text;
    want('"');
    for (; m_at < m_text.size() && m_text[m_at] != '"'; ++m_at)
    {
      if (static_cast<unsigned char>(m_text[m_at]) < 0x20) fail("a control character");
      result.text += m_text[m_at] == '\\' ? escape() : m_text[m_at];
    }
    if (m_at >= m_text.size()) fail("a string without end");
    ++m_at;
    return result;
  }

  char escape()
  {
    if (++m_at >= m_text.size()) fail("end of text");
    const char* known = "\"\"\\\\//b\bf\fn\nr\rt\t";
    for (const char* pair = known; *pair; pair += 2)
      if (*pair == m_text[m_at]) return pair[1];
    if (m_text[m_at] != 'u' || m_at + 4 >= m_text.size()) fail("a bad escape");
    const std::string hex = m_text.substr(m_at + 1, 4);
    if (hex.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) fail("a bad \\u");
    m_at += 4;
    return static_cast<char>(std::strtol(hex.c_str(), nullptr, 16));  // tests use ASCII only
  }

  JsonValue word()
  {
    std::size_t end = m_at;
    while (end < m_text.size() && !std::strchr(" \t\r\n,]}", m_text[end])) ++end;
    const std::string token = m_text.substr(m_at, end - m_at);
    static const std::regex number("-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][-+]?[0-9]+)?");
    JsonValue result;
    if (token == "true" || token == "false")
    {
      result.kind = JsonValue::Kind::Bool;
      result.truth = token == "true";
    }
    else if (std::regex_match(token, number))
    {
      result.kind = JsonValue::Kind::Number;
      result.number = std::strtod(token.c_str(), nullptr);
    }
    else if (token != "null")
      fail("'" + token + "' is no value");
    m_at = end;
    return result;
  }

  const std::string& m_text;
  std::size_t m_at = 0;
};
}  // namespace

JsonValue parseJson(const std::string& text) { return Parser(text).whole(); }

}  // namespace mrpt_mapconv::testing
