#include <mrpt_mapconv/params/IniText.h>
#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/params/Text.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace mrpt_mapconv::params
{
namespace
{
std::string readText(const std::string& path)
{
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored))
    throw std::runtime_error(path + ": is a folder, not an ini file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be opened: " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool isComment(const std::string& line)
{
  return line[0] == ';' || line[0] == '#' || line.compare(0, 2, "//") == 0;
}

bool isSection(const std::string& line)
{
  return line[0] == '[' && line.find(']') != std::string::npos;
}

bool isDirective(const std::string& line) { return line[0] == '@'; }  // MRPT's @define

bool isKey(const std::string& line)
{
  const auto equals = line.find('=');
  return equals != std::string::npos && equals > 0;
}

[[noreturn]] void failAt(const std::string& path, int line, const std::string& what)
{
  throw std::runtime_error(path + ": line " + std::to_string(line) + ": " + what);
}

/** Throws for sections and keys that are there twice. */
class TwiceCheck
{
 public:
  explicit TwiceCheck(const std::string& path) : m_path(path) {}

  void section(const std::string& line, int number)
  {
    m_section = trimmed(line.substr(1, line.find(']') - 1));
    m_keys.clear();
    refuseTwice(m_sections, m_section, number, "section '" + m_section + "'");
  }

  void key(const std::string& line, int number)
  {
    const std::string key = trimmed(line.substr(0, line.find('=')));
    refuseTwice(m_keys, key, number, "section '" + m_section + "': key '" + key + "'");
  }

 private:
  using Lines = std::map<std::string, int>;  //!< of names in small letters

  void refuseTwice(Lines& lines, std::string name, int number, const std::string& what) const
  {
    // to MRPT, [A] and [a] are the same
    const auto [first, isNew] = lines.emplace(lowerCase(std::move(name)), number);
    if (isNew) return;
    failAt(m_path, number,
           what + " is already in line " + std::to_string(first->second) +
               "; it must be there only once");
  }

  const std::string& m_path;
  std::string m_section;
  Lines m_sections, m_keys;
};

void checkLines(const std::string& text, const std::string& path)
{
  std::istringstream lines(text);
  TwiceCheck twice(path);
  bool continued = false;  // a backslash at its end continues a line in the next
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    line = trimmed(line);
    if (line.empty())
    {
      continued = false;
      continue;
    }
    if (!continued && !isComment(line) && !isDirective(line))
    {
      if (isSection(line))
        twice.section(line, number);
      else if (isKey(line))
        twice.key(line, number);
      else
        failAt(path, number, "'" + printable(line, 80) + "' is no section, comment or key = value");
    }
    continued = line.back() == '\\';
  }
}
}  // namespace

std::string readIniText(const std::string& path)
{
  std::string text = withoutByteOrderMark(readText(path));
  checkLines(text, path);
  return text;
}

}  // namespace mrpt_mapconv::params
