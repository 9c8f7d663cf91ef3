#pragma once

#include <mrpt/config/CConfigFileBase.h>

#include <cstdint>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace mrpt_mapconv::params
{
/** One section of an ini file, read strictly.
 *
 * MRPT's own reading takes "banana" for 0 and "1,5" for 1; here a value that is not wholly what the
 * key asks for is an error, and keys that nobody asked for can be named afterwards. A comment after
 * the value ("; …", "# …" or "// …") is no part of it.
 */
class StrictSection
{
 public:
  StrictSection(const mrpt::config::CConfigFileBase& source, std::string section);

  const std::string& name() const { return m_section; }
  /** True for a key with just these capitals, so that what is read is not called unknown. */
  bool has(const std::string& key) const;

  /** Reads a key if it is there; else the value stays as it is.
   * \exception std::runtime_error naming section, key and value, and what would be right */
  void read(const std::string& key, double& value);
  void read(const std::string& key, float& value);
  void read(const std::string& key, std::int32_t& value);
  void read(const std::string& key, std::uint32_t& value);
  void read(const std::string& key, std::uint16_t& value);
  void read(const std::string& key, std::optional<double>& value);  //!< a number, or auto for none
  void read(const std::string& key, std::optional<std::int32_t>& value);
  /** Numbers between spaces, commas or brackets. */
  void read(const std::string& key, std::vector<double>& values);
  void read(const std::string& key, bool& value);         //!< true/false, yes/no, 1/0
  void read(const std::string& key, std::string& value);  //!< without the blanks around it
  /** One of `choices`; gives its index. */
  void readChoice(const std::string& key, const std::vector<std::string>& choices, int& index);

  /** Throws that the value of a key that has been read is not valid. The message has no brackets
   * around the section: MRPT takes what stands before a ']' for a place in its code.
   * \param right what would be, e.g. "> 0" */
  [[noreturn]] void fail(const std::string& key, const std::string& right) const;

  /** Calls check(), whose complaint about a parameter then names the section as well.
   * \exception std::runtime_error for its std::invalid_argument */
  template <class Check>
  void checked(const Check& check) const
  {
    try
    {
      check();
    }
    catch (const std::invalid_argument& error)
    {
      throw std::runtime_error("section '" + m_section + "': " + error.what());
    }
  }

  /** Declares a key as known that something else reads. */
  void ignore(const std::string& key) { m_known.insert(key); }
  /** Keys of the section that were neither read nor ignored, in alphabetical order. */
  std::vector<std::string> unknownKeys() const;
  /** \param owner what has the keys that were read, e.g. "a lidar"
   * \exception std::runtime_error naming section and key if there is an unknown one */
  void refuseUnknown(const std::string& owner) const;
  /** One warning for all unknown keys, on MRPT's log; silent if there are none. */
  void warnUnknown() const;

 private:
  std::string text(const std::string& key);
  template <class Number>
  void readNumber(const std::string& key, Number& value);

  const mrpt::config::CConfigFileBase& m_source;
  std::string m_section;
  std::set<std::string> m_known;
};

}  // namespace mrpt_mapconv::params
