#include <mrpt/system/COutputLogger.h>
#include <mrpt_mapconv/params/Fields.h>
#include <mrpt_mapconv/params/StrictSection.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace mrpt_mapconv::params
{
namespace
{
bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/** The value without a comment that follows it: ';', '#' or "//" at its start or after a space. */
std::string withoutComment(const std::string& value)
{
  for (std::size_t i = 0; i < value.size(); ++i)
  {
    const bool opens = value[i] == ';' || value[i] == '#' || value.compare(i, 2, "//") == 0;
    if (opens && (i == 0 || isSpace(value[i - 1]))) return value.substr(0, i);
  }
  return value;
}
}  // namespace

StrictSection::StrictSection(const mrpt::config::CConfigFileBase& source, std::string section)
    : m_source(source), m_section(std::move(section))
{
}

bool StrictSection::has(const std::string& key) const
{
  // MRPT finds a key whatever its capitals, but lists it as it is
  std::vector<std::string> keys;
  m_source.getAllKeys(m_section, keys);
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

std::string StrictSection::text(const std::string& key)
{
  m_known.insert(key);
  return trimmed(withoutComment(m_source.read_string(m_section, key, "")));
}

void StrictSection::fail(const std::string& key, const std::string& right) const
{
  const auto value = trimmed(withoutComment(m_source.read_string(m_section, key, "")));
  throw std::runtime_error("section '" + m_section + "': " + key + " = '" + value +
                           "' is not valid: it must be " + right);
}

template <class Number>
void StrictSection::readNumber(const std::string& key, Number& value)
{
  m_known.insert(key);
  if (!has(key)) return;
  if (!params::readNumber(text(key), value)) fail(key, rightTextOf(value));
}

void StrictSection::read(const std::string& key, std::vector<double>& values)
{
  m_known.insert(key);
  if (!has(key)) return;
  std::string list = text(key);
  std::replace_if(
      list.begin(), list.end(), [](char c) { return c == ',' || c == '[' || c == ']'; }, ' ');
  std::vector<double> numbers;
  std::istringstream words(list);
  for (std::string word; words >> word;)
    if (!params::readNumber(word, numbers.emplace_back())) fail(key, "a list of finite numbers");
  if (numbers.empty()) fail(key, "a list of finite numbers");
  values = std::move(numbers);
}

void StrictSection::read(const std::string& key, double& value) { readNumber(key, value); }
void StrictSection::read(const std::string& key, float& value) { readNumber(key, value); }
void StrictSection::read(const std::string& key, std::int32_t& value) { readNumber(key, value); }
void StrictSection::read(const std::string& key, std::uint32_t& value) { readNumber(key, value); }

void StrictSection::read(const std::string& key, std::uint16_t& value) { readNumber(key, value); }

void StrictSection::read(const std::string& key, std::optional<double>& value)
{
  m_known.insert(key);
  if (!has(key)) return;
  if (!readNumberOrAuto(text(key), value)) fail(key, rightTextOf(value));
}

void StrictSection::read(const std::string& key, std::optional<std::int32_t>& value)
{
  m_known.insert(key);
  if (!has(key)) return;
  if (!readNumberOrAuto(text(key), value)) fail(key, rightTextOf(value));
}

void StrictSection::read(const std::string& key, std::string& value)
{
  m_known.insert(key);
  if (has(key)) value = text(key);
}

void StrictSection::read(const std::string& key, bool& value)
{
  m_known.insert(key);
  if (!has(key)) return;
  const std::string word = lowerCase(text(key));
  for (const char* yes : {"true", "yes", "1"})
    if (word == yes)
    {
      value = true;
      return;
    }
  for (const char* no : {"false", "no", "0"})
    if (word == no)
    {
      value = false;
      return;
    }
  fail(key, rightTextOf(value));
}

void StrictSection::readChoice(const std::string& key, const std::vector<std::string>& choices,
                               int& index)
{
  m_known.insert(key);
  if (!has(key)) return;
  const auto it = std::find(choices.begin(), choices.end(), text(key));
  if (it == choices.end()) fail(key, alternatives(choices));
  index = static_cast<int>(it - choices.begin());
}

std::vector<std::string> StrictSection::unknownKeys() const
{
  std::vector<std::string> keys;
  m_source.getAllKeys(m_section, keys);
  // MRPT takes a line "// key = value" for a key, its users take it for a comment
  const auto isKnown = [&](const std::string& key)
  { return m_known.count(key) != 0 || key.rfind("//", 0) == 0; };
  keys.erase(std::remove_if(keys.begin(), keys.end(), isKnown), keys.end());
  return keys;
}

void StrictSection::refuseUnknown(const std::string& owner) const
{
  const auto keys = unknownKeys();
  if (keys.empty()) return;
  throw std::runtime_error("section '" + m_section + "': '" + keys.front() + "' is not a key of " +
                           owner + ": correct its name or take it out");
}

void StrictSection::warnUnknown() const
{
  const auto keys = unknownKeys();
  if (keys.empty()) return;
  std::string names;
  for (const auto& key : keys) names += (names.empty() ? "'" : ", '") + key + "'";
  mrpt::system::COutputLogger log("mrpt_mapconv");
  log.logStr(mrpt::system::LVL_WARN,
             "section '" + m_section + "': unknown key " + names + " has no effect");
}

}  // namespace mrpt_mapconv::params
