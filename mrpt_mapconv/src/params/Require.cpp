#include <mrpt_mapconv/params/Printable.h>
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
  const bool isOfMrpt = text.find("MRPT exception ====") != std::string::npos;
  for (const char* label : {"Message:", "Location:"})
    if (auto line = lineBehind(text, label); isOfMrpt && !line.empty()) return line;
  return printable(text);  // names of files may have several lines
}

}  // namespace mrpt_mapconv::params
