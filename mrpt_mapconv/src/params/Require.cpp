#include <mrpt_mapconv/params/Require.h>

namespace mrpt_mapconv::params
{
namespace
{
/** The rest of the line behind a label; empty if the label is missing. */
std::string lineBehind(const std::string& text, const std::string& label)
{
  const auto at = text.find(label);
  if (at == std::string::npos) return "";
  const auto begin = text.find_first_not_of(' ', at + label.size());
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find('\n', begin) - begin);
}
}  // namespace

std::string oneLine(const std::exception& error)
{
  const std::string text = error.what();
  // An exception that passed through MRPT has an empty message and its text in the location.
  for (const char* label : {"Message:", "Location:"})
    if (auto line = lineBehind(text, label); !line.empty()) return line;
  return text.substr(0, text.find('\n'));
}

}  // namespace mrpt_mapconv::params
