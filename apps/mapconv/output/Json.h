#pragma once

#include <mrpt_mapconv/params/Fields.h>

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace mapconv
{
/** `text` as a JSON string; bytes that are no UTF-8 become U+FFFD, since JSON has no others. */
std::string jsonString(std::string_view text);
/** The shortest number that reads back as the same double; null for NaN and infinity, which JSON
 * does not have. */
std::string jsonNumber(double value);

/** A JSON object that keeps its members in the order in which they were added. */
class JsonObject
{
 public:
  template <class Value>
  JsonObject& add(const std::string& key, const Value& value)
  {
    if constexpr (std::is_same_v<Value, JsonObject>)
      return addRaw(key, value.text());
    else if constexpr (std::is_same_v<Value, bool>)
      return addRaw(key, value ? "true" : "false");
    else if constexpr (std::is_floating_point_v<Value>)
      return addRaw(key, jsonNumber(value));
    else if constexpr (std::is_integral_v<Value>)
      return addRaw(key, std::to_string(value));
    else
      return addRaw(key, jsonString(value));
  }
  JsonObject& add(const std::string& key, const std::vector<std::string>& values);

  /** The object on one line, without a line's end. */
  std::string text() const { return "{" + m_members + "}"; }

 private:
  JsonObject& addRaw(const std::string& key, const std::string& value);

  std::string m_members;
};

/** Adds all fields of a struct with a list (params/Fields.h), named and in the units of its ini
 * file.
 */
template <class Params>
void addFields(const Params& params, JsonObject& json)
{
  namespace fields = mrpt_mapconv::params;
  fields::visitFields(
      params,
      [&json](const char* name, const auto& field, const char*, const char*, fields::About = {})
      { fields::showValue(field, [&](const auto& value) { json.add(name, value); }); });
}

}  // namespace mapconv
