#include <mrpt_mapconv/maps/IniText.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace mrpt_mapconv::maps
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

/** Whether a line without blanks around it means something to MRPT. */
bool isIniLine(const std::string& line)
{
  const bool comment = line[0] == ';' || line[0] == '#' || line.compare(0, 2, "//") == 0;
  const bool section = line[0] == '[' && line.find(']') != std::string::npos;
  const bool directive = line[0] == '@';  // MRPT's @define
  const auto equals = line.find('=');
  return comment || section || directive || (equals != std::string::npos && equals > 0);
}

void checkLines(const std::string& text, const std::string& path)
{
  std::istringstream lines(text);
  bool continued = false;  // a backslash at its end continues a line in the next
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    const auto begin = line.find_first_not_of(" \t\r"), end = line.find_last_not_of(" \t\r");
    const bool blank = begin == std::string::npos;
    if (!blank) line = line.substr(begin, end + 1 - begin);
    if (!blank && !continued && !isIniLine(line))
      throw std::runtime_error(path + ": line " + std::to_string(number) + ": '" + line +
                               "' is no section, comment or key = value");
    continued = !blank && line.back() == '\\';
  }
}
}  // namespace

std::string readIniText(const std::string& path)
{
  std::string text = readText(path);
  checkLines(text, path);
  return text;
}

}  // namespace mrpt_mapconv::maps
