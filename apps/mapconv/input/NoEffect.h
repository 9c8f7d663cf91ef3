#pragma once

#include <string>
#include <vector>

namespace mapconv
{
/** Flags and keys of an ini file that change nothing on an input: named in one warning. */
class NoEffect
{
 public:
  /** \param names as the user wrote them, e.g. "--static"; none: nothing to be said
   * \param why e.g. "map.bt is no rawlog" */
  void add(const std::vector<std::string>& names, const std::string& why);
  /** The same for keys of an ini file. */
  void addKeys(std::vector<std::string> keys, const std::string& iniFile, const std::string& why);
  /** Prints the warning; nothing if nothing was added. */
  void warn() const;

 private:
  std::string m_text;
};

}  // namespace mapconv
