#include "SourceFiles.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace mrpt_mapconv::house
{
namespace fs = std::filesystem;

std::vector<fs::path> filesBelow(const fs::path& folder, const std::vector<std::string>& endings)
{
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
  {
    const std::string name = entry.path().filename().string();
    const auto endsSo = [&](const std::string& ending)
    {
      return name.size() >= ending.size() &&
             name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
    };
    if (std::any_of(endings.begin(), endings.end(), endsSo)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> sourcesBelow(const fs::path& folder)
{
  return filesBelow(folder, {".h", ".cpp"});
}

std::vector<std::string> namesIn(const fs::path& folder)
{
  std::vector<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string textOf(const fs::path& file)
{
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> allMatches(const std::string& text, const std::string& pattern)
{
  const std::regex regex(pattern, std::regex::ECMAScript | std::regex::multiline);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

}  // namespace mrpt_mapconv::house
