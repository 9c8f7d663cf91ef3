#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt_mapconv/params/Fields.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace mapconv
{
/** "maxStep" becomes "--max-step". */
inline std::string flagName(const std::string& field)
{
  std::string flag = "--";
  for (const char c : field)
  {
    if (std::isupper(static_cast<unsigned char>(c))) flag += '-';
    flag += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return flag;
}

/** Command-line flags for the fields of a struct whose list (params/Fields.h) says that they have
 * one. What was given goes into a section of an ini, so that there is one way from text to struct.
 */
template <class Params>
class FieldFlags
{
 public:
  /** \param app keeps pointing at this object
   * \param first asked of each number before the struct is; else the parser complains of what is
   * none */
  void addTo(CLI::App& app, const std::optional<CLI::Validator>& first = {})
  {
    namespace fields = mrpt_mapconv::params;
    fields::visitFields(m_defaults,
                        [&](const char* name, const auto& field, const std::string& unit,
                            const std::string& meaning, fields::About about = {})
                        {
                          if (!about.flagType) return;
                          const std::string help =
                              withUnit(meaning, unit) + ", default " + fields::textOf(field);
                          add(app, name, field, help, first)->type_name(about.flagType);
                        });
    if constexpr (fields::hasNamedSet<Params>)
      app.add_flag(flagName(Params::kNamedSet), m_isNamedSetTaken,
                   std::string(Params::kNamedSetMeaning) + "; other flags replace what they name");
  }

  bool given(const std::string& field) const { return m_given.count(field) != 0; }
  /** Sets the fields of those that were given; what is valid together is for the caller to check.
   */
  void applyTo(Params& params) const
  {
    if constexpr (mrpt_mapconv::params::hasNamedSet<Params>)
      if (m_isNamedSetTaken) params.takeNamedSet();
    mrpt_mapconv::params::visitFields(params,
                                      [this](const char* name, auto&& field, const char*,
                                             const char*, mrpt_mapconv::params::About = {})
                                      {
                                        const auto text = m_given.find(name);
                                        if (text != m_given.end())
                                          mrpt_mapconv::params::setFromText(text->second, field);
                                      });
  }
  /** Writes those that were given into a section; they replace what is there. */
  void writeTo(mrpt::config::CConfigFileBase& ini, const std::string& section) const
  {
    for (const auto& [field, text] : m_given) ini.write(section, field, text);
  }

 private:
  /** The unit stands before what a semicolon adds. */
  static std::string withUnit(const std::string& meaning, const std::string& unit)
  {
    const auto end = std::min(meaning.find(';'), meaning.size());
    return meaning.substr(0, end) + (unit.empty() ? "" : " [" + unit + "]") + meaning.substr(end);
  }

  template <class Field>
  CLI::Option* add(CLI::App& app, const std::string& name, const Field& field,
                   const std::string& help, const std::optional<CLI::Validator>& first)
  {
    namespace fields = mrpt_mapconv::params;
    using Value = std::decay_t<decltype(fields::shownValue(field))>;
    CLI::Option* option = app.add_option_function<Value>(
        flagName(name), [this, name](const Value& value) { m_given[name] = fields::textOf(value); },
        help);
    if constexpr (std::is_enum_v<Field>)
      return option->check(CLI::IsMember(namesOf(field)));
    else
    {
      if (first && !std::is_same_v<Field, bool>) option->check(*first);
      return option->check(isValid<Value>(name));
    }
  }

  template <class Number>
  CLI::Option* add(CLI::App& app, const std::string& name, const std::optional<Number>&,
                   const std::string& help, const std::optional<CLI::Validator>&)
  {
    return app
        .add_option_function<std::string>(
            flagName(name), [this, name](const std::string& text) { m_given[name] = text; }, help)
        ->check(isValidOrAuto<std::optional<Number>>(name));
  }

  /** What is valid is asked of the struct, which may complain of other fields: those come later. */
  template <class Value>
  static CLI::Validator isValid(const std::string& name)
  {
    return CLI::Validator(
        [name](std::string& text)
        {
          if (text.empty()) return std::string("'' is no number");
          Value value{};
          // What is no number is left to the parser's own complaint.
          if (!CLI::detail::lexical_cast(text, value)) return std::string();
          return complaintAbout(name, value);
        },
        "");
  }

  template <class Field>
  static CLI::Validator isValidOrAuto(const std::string& name)
  {
    return CLI::Validator(
        [name](std::string& text)
        {
          Field value;
          if (!mrpt_mapconv::params::setFromText(text, value))
            return "'" + text + "' is not valid: it must be " +
                   mrpt_mapconv::params::rightTextOf(value);
          return complaintAbout(name, value);
        },
        "");
  }

  template <class Value>
  static std::string complaintAbout(const std::string& name, const Value& value)
  {
    Params tried;
    mrpt_mapconv::params::visitFields(tried,
                                      [&](const char* fieldName, auto&& field, const char*,
                                          const char*, mrpt_mapconv::params::About = {})
                                      {
                                        using Field = std::decay_t<decltype(field)>;
                                        if (fieldName != name) return;
                                        if constexpr (mrpt_mapconv::params::isDegrees<Field>)
                                          field.set(value);
                                        else if constexpr (std::is_convertible_v<Value, Field>)
                                          field = static_cast<Field>(value);
                                      });
    try
    {
      tried.check();
    }
    catch (const std::invalid_argument& error)
    {
      const std::string complaint = error.what();
      if (complaint.rfind(name + " = ", 0) == 0) return complaint;
    }
    return "";
  }

  Params m_defaults;
  bool m_isNamedSetTaken = false;
  std::map<std::string, std::string> m_given;  //!< by the field's name
};

}  // namespace mapconv
