#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/core/format.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/params/StrictSection.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/** A parameter is listed once: a struct says what its fields are, and reading and saving ini files,
 * printing, MRPT's streams, metadata, JSON, command-line flags and the documentation's tables
 * follow from that list.
 *
 * \code
 * struct ConversionParams
 * {
 *   double minClearance = 1.0;  //!< R_maxZ [m]
 *   template <class S, class V>
 *   static void visit(S& p, V&& v)
 *   {
 *     v("minClearance", p.minClearance, "m", "a free range must be at least this high",
 *       params::flag("M"));
 *   }
 *   void check() const;  // see require()
 * };
 * \endcode
 *
 * S is the struct or its const. V is called with (name, field, unit, meaning) and, where there is
 * more to say, an About. A field is a number, a bool, an enumeration, a number in Degrees, or an
 * optional number, which is written "auto" where there is none: what is right for the map at hand.
 * A struct that holds another one calls its visit(). An enumeration has a function `const
 * std::vector<std::string>& namesOf(Enum)` beside it: its values' names, from 0 on. */
namespace mrpt_mapconv::params
{
/** What a list says of a field beside its name, unit and meaning. */
struct About
{
  std::uint8_t sinceVersion = 0;   //!< of the stream: an older one does not have the field
  const char* flagType = nullptr;  //!< how help calls the flag's value; null: there is no flag

  About since(std::uint8_t version) const { return {version, flagType}; }
};
/** The field came with this version of the stream that it is written to; what is read from an older
 * one leaves it at its default. */
inline About since(std::uint8_t version) { return {version, nullptr}; }
/** The field has a command-line flag, its name in kebab-case. \param type of its value, e.g. "M" */
inline About flag(const char* type) { return {0, type}; }

/** An angle that is kept, and streamed, in radians and written in degrees. A negative one stands
 * for a default and is the same in both. */
template <class Number>
struct Degrees
{
  Number& radians;

  explicit Degrees(Number& angle) : radians(angle) {}
  std::remove_const_t<Number> value() const
  {
    return radians < 0 ? radians : mrpt::RAD2DEG(radians);
  }
  void set(Number degrees) const { radians = degrees < 0 ? degrees : mrpt::DEG2RAD(degrees); }
};

/** Where the list of a struct is: in the struct. A specialization gives one to a struct of somebody
 * else. */
template <class Params>
struct FieldsOf
{
  template <class S, class V>
  static void visit(S& params, V&& v)
  {
    Params::visit(params, v);
  }
};
/** Calls v for each field in the list of a struct. */
template <class Params, class V>
void visitFields(Params& params, V&& v)
{
  FieldsOf<std::remove_const_t<Params>>::visit(params, v);
}

/** Whether the list of a struct has a field of that name. */
template <class Params>
bool hasField(const std::string& name)
{
  bool found = false;
  const Params params;
  visitFields(params, [&](const char* field, const auto&, const char*, const char*, About = {})
              { found |= field == name; });
  return found;
}

template <class Field>
constexpr bool isDegrees = false;
template <class Number>
constexpr bool isDegrees<Degrees<Number>> = true;

template <class Field>
constexpr bool isOptional = false;
template <class Number>
constexpr bool isOptional<std::optional<Number>> = true;

/** A struct may have values that are known by a name: `static constexpr const char* kNamedSet`, its
 * meaning in `kNamedSetMeaning`, and takeNamedSet(). `name = true` in a section takes them; keys
 * beside it replace what they name. */
template <class Params, class = void>
constexpr bool hasNamedSet = false;
template <class Params>
constexpr bool hasNamedSet<Params, std::void_t<decltype(Params::kNamedSet)>> = true;

namespace internal
{
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();  // in a stream

/** The double that is written as briefly as the float is: 0.65 and not 0.6499999761581421. */
inline double asWritten(float value)
{
  double number = value;
  readWhole(shortestText(value), number);
  return number;
}
}  // namespace internal

/** A field's value as files and people see it: a bool, an integer, a double or a name. */
template <class Field>
auto shownValue(const Field& field)
{
  if constexpr (isDegrees<Field>)
    return shownValue(field.value());
  else if constexpr (std::is_enum_v<Field>)
    return namesOf(field).at(static_cast<std::size_t>(field));
  else if constexpr (std::is_same_v<Field, float>)
    return internal::asWritten(field);
  else
    return field;
}

/** Calls show() with the value as files and people see it: a bool, a number, or a text. */
template <class Field, class Show>
void showValue(const Field& field, const Show& show)
{
  if constexpr (!isOptional<Field>)
    show(shownValue(field));
  else if (field)
    show(shownValue(*field));
  else
    show(std::string(kAuto));
}

/** The value as a text that reads back as the same. */
template <class Field>
std::string textOf(const Field& field)
{
  std::string text;
  showValue(field,
            [&text](const auto& value)
            {
              using Value = std::decay_t<decltype(value)>;
              if constexpr (std::is_same_v<Value, std::string>)
                text = value;
              else if constexpr (std::is_same_v<Value, bool>)
                text = value ? "true" : "false";
              else
                text = shortestText(value);
            });
  return text;
}

/** Reads what textOf() gives, wholly; an optional number as an ini file may have it. \return false,
 * and the field as it was, for any other text */
template <class Field>
bool setFromText(const std::string& text, Field&& field)
{
  using Value = std::decay_t<Field>;
  if constexpr (isDegrees<Value>)
  {
    auto degrees = field.value();
    if (!readWhole(text, degrees)) return false;
    field.set(degrees);
    return true;
  }
  else if constexpr (isOptional<Value>)
    return readNumberOrAuto(text, field);
  else if constexpr (std::is_same_v<Value, bool>)
  {
    if (text != "true" && text != "false") return false;
    field = text == "true";
    return true;
  }
  else if constexpr (std::is_enum_v<Value>)
  {
    const auto& names = namesOf(field);
    const auto name = std::find(names.begin(), names.end(), text);
    if (name == names.end()) return false;
    field = static_cast<Value>(name - names.begin());
    return true;
  }
  else
    return readWhole(text, field);
}

/** What setFromText() reads, for errors: "it must be …". */
template <class Field>
std::string rightTextOf(const Field& field)
{
  if constexpr (isDegrees<Field>)
    return rightTextOf(field.value());
  else if constexpr (isOptional<Field>)
    return alternatives({rightTextOf(typename Field::value_type{}), kAuto});
  else if constexpr (std::is_same_v<Field, bool>)
    return alternatives({"true", "false"});
  else if constexpr (std::is_enum_v<Field>)
    return alternatives(namesOf(field));
  else
    return std::is_integral_v<Field> ? "a whole number" : "a finite number";
}

/** False for a number that is not set (NaN), which a file leaves out. */
template <class Field>
bool isSet(const Field& field)
{
  if constexpr (isDegrees<Field>)
    return isSet(field.value());
  else if constexpr (std::is_floating_point_v<Field>)
    return !std::isnan(field);
  else
    return true;
}

/** Reads the keys of a section that are there into their fields; others stay as they are.
 * \exception std::runtime_error as StrictSection::read() */
template <class Params>
void readFields(StrictSection& ini, Params& params)
{
  if constexpr (hasNamedSet<Params>)
  {
    bool isTaken = false;
    ini.read(Params::kNamedSet, isTaken);
    if (isTaken) params.takeNamedSet();
  }
  visitFields(params,
              [&ini](const char* name, auto&& field, const char*, const char*, About = {})
              {
                using Field = std::decay_t<decltype(field)>;
                if constexpr (isDegrees<Field>)
                {
                  auto degrees = field.value();
                  ini.read(name, degrees);
                  if (ini.has(name)) field.set(degrees);
                }
                else if constexpr (std::is_enum_v<Field>)
                {
                  int index = static_cast<int>(field);
                  ini.readChoice(name, namesOf(field), index);
                  field = static_cast<Field>(index);
                }
                else
                  ini.read(name, field);
              });
}

/** Calls visit(name, text) for all fields that are set, with texts that read back the same. */
template <class Params, class Visit>
void forEachText(const Params& params, const Visit& visit)
{
  visitFields(params,
              [&visit](const char* name, const auto& field, const char*, const char*, About = {})
              {
                if (isSet(field)) visit(name, textOf(field));
              });
}

/** Writes all fields that are set into a section, such that they read the same. */
template <class Params>
void saveFields(const Params& params, mrpt::config::CConfigFileBase& target,
                const std::string& section)
{
  forEachText(params, [&](const char* name, const std::string& text)
              { target.write(section, name, text); });
}

/** Prints "name = value" lines as MRPT prints its options. */
template <class Params>
void printFields(const Params& params, std::ostream& out)
{
  visitFields(params,
              [&out](const char* name, const auto& field, const char*, const char*, About = {})
              {
                out << std::left << std::setw(41) << name << "= ";
                showValue(field,
                          [&out](const auto& value)
                          {
                            using Value = std::decay_t<decltype(value)>;
                            if constexpr (std::is_same_v<Value, bool>)
                              out << (value ? "YES" : "NO") << "\n";
                            else if constexpr (std::is_same_v<Value, double>)
                              out << mrpt::format("%f", value) << "\n";
                            else
                              out << value << "\n";
                          });
              });
}

/** Appends all fields to a stream, in the order of the list; what they are has to be known. */
template <class Params>
void writeFields(const Params& params, mrpt::serialization::CArchive& out)
{
  visitFields(params,
              [&out](const char*, const auto& field, const char*, const char*, About = {})
              {
                using Field = std::decay_t<decltype(field)>;
                if constexpr (isDegrees<Field>)
                  out << field.radians;
                else if constexpr (isOptional<Field>)
                  out << (field ? static_cast<double>(*field) : internal::kNoNumber);
                else if constexpr (std::is_enum_v<Field>)
                  out << static_cast<std::uint8_t>(field);
                else
                  out << field;
              });
}

/** Reads what writeFields() wrote. Values are not checked.
 * \param version of the stream: fields that came later stay as they are
 * \param what the stream's owner, for the error, e.g. "conversion options"
 * \exception std::exception for a stream that ends, or a number that stands for no name */
template <class Params>
void readFields(mrpt::serialization::CArchive& in, Params& params, std::uint8_t version,
                const std::string& what)
{
  visitFields(
      params,
      [&](const char* name, auto&& field, const char*, const char*, About about = {})
      {
        using Field = std::decay_t<decltype(field)>;
        if (about.sinceVersion > version) return;
        if constexpr (isDegrees<Field>)
          in >> field.radians;
        else if constexpr (isOptional<Field>)
        {
          double number = 0;
          in >> number;
          field.reset();
          if (!std::isnan(number)) field = static_cast<typename Field::value_type>(number);
        }
        else if constexpr (std::is_enum_v<Field>)
        {
          std::uint8_t index = 0;
          in >> index;
          if (index >= namesOf(field).size())
            throw std::runtime_error(what + ": unknown " + name + " " + std::to_string(index));
          field = static_cast<Field>(index);
        }
        else
          in >> field;
      });
}

}  // namespace mrpt_mapconv::params
