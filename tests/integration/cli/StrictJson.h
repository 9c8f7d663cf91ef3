#pragma once

#include <map>
#include <string>
#include <vector>

namespace mrpt_mapconv::testing
{
/** A JSON value, as RFC 8259 has it and nothing more lenient. */
struct JsonValue
{
  enum class Kind
  {
    Null,
    Bool,
    Number,
    Text,
    List,
    Object
  };
  Kind kind = Kind::Null;
  bool truth = false;
  double number = 0;
  std::string text;
  std::vector<JsonValue> list;
  std::map<std::string, JsonValue> object;

  bool has(const std::string& key) const { return object.count(key) != 0; }
  /** \exception std::out_of_range if there is no such member */
  const JsonValue& operator[](const std::string& key) const { return object.at(key); }
};

/** \exception std::runtime_error saying where, if the text is not exactly one JSON value */
JsonValue parseJson(const std::string& text);

}  // namespace mrpt_mapconv::testing
