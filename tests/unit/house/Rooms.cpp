#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include "House.h"
#include "SourceFiles.h"

namespace mrpt_mapconv::house
{
namespace fs = std::filesystem;

namespace
{
constexpr const char* kOurs = "mrpt_mapconv";

/** The lines below the heading that holds some words, up to the next heading. */
std::string sectionOf(const std::string& page, const std::string& words)
{
  std::istringstream in(page);
  std::string section, line;
  bool inSection = false;
  while (std::getline(in, line))
    if (line.rfind("#", 0) == 0)
      inSection = line.find(words) != std::string::npos;
    else if (inSection)
      section += line + "\n";
  return section;
}

/** One of the two folders that hold rooms, and what a quoted or an angled include names in it. */
class RoomFolder
{
 public:
  RoomFolder(const fs::path& root, const fs::path& inRoot, const Floors& floors)
      : m_root(root), m_folder(root / inRoot), m_floors(floors)
  {
  }

  Complaints complaints()
  {
    for (const std::string& name : namesIn(m_folder))
      if (!m_floors.has(name)) complain(m_folder / name, "is no room that the page lists");
    for (const fs::path& file : sourcesBelow(m_folder)) look(file);
    return m_complaints;
  }

 private:
  void look(const fs::path& file)
  {
    const std::string room = roomOf(file);
    if (!m_floors.has(room)) return;  // complained of as a folder
    const std::string text = textOf(file);
    for (const std::string& name :
         allMatches(text, "^[ \t]*#[ \t]*include[ \t]*[<\"](mrpt_mapconv/[^>\"]+)[>\"]"))
      checkArrow(file, room, name, (*++fs::path(name).begin()).string());
    for (const std::string& name :
         allMatches(text, "^[ \t]*#[ \t]*include[ \t]*\"((?!mrpt_mapconv/)[^\"]+)\""))
      checkPrivate(file, room, name);
    for (const std::string& name :
         allMatches(text, "^[ \t]*(?:inline[ \t]+)?namespace[ \t]+(mrpt_mapconv[\\w:]*)"))
      checkNamespace(file, room, name);
  }

  void checkArrow(const fs::path& file, const std::string& room, const std::string& include,
                  const std::string& other)
  {
    if (!m_floors.has(other))
      complain(file, "includes " + include + ", which is of no room");
    else if (!m_floors.mayInclude(room, other))
      complain(file, "includes " + include + ": room " + room + " lies below " + other);
  }

  void checkPrivate(const fs::path& file, const std::string& room, const std::string& include)
  {
    const fs::path target = (file.parent_path() / include).lexically_normal();
    const fs::path inFolder = target.lexically_relative(m_folder);
    if (!fs::exists(target) || *inFolder.begin() == "..")
      complain(file, "includes \"" + include + "\", which is no header beside it or of a room");
    else
      checkArrow(file, room, include, roomOf(target));
  }

  void checkNamespace(const fs::path& file, const std::string& room, const std::string& name)
  {
    const std::string own = std::string(kOurs) + "::" + room;
    const bool mapClass = room == "maps" && name == kOurs;
    if (name != own && name.rfind(own + "::", 0) != 0 && !mapClass)
      complain(file, "has namespace " + name + " instead of " + own);
  }

  std::string roomOf(const fs::path& file) const
  {
    return (*file.lexically_relative(m_folder).begin()).string();
  }
  void complain(const fs::path& file, const std::string& what)
  {
    m_complaints.push_back(file.lexically_relative(m_root).string() + ": " + what);
  }

  fs::path m_root, m_folder;
  const Floors& m_floors;
  Complaints m_complaints;
};
}  // namespace

Floors::Floors(const fs::path& root)
{
  const std::string section = sectionOf(textOf(root / kPage), "Rooms of the library");
  m_names = allMatches(section, "^\\| *`(\\w+)` *\\|");
  if (m_names.empty())
    throw std::runtime_error(std::string(kPage) +
                             ": no table of rooms below a heading \"Rooms of the library\"");
  const std::string after = section.substr(section.rfind("\n|") + 1);
  for (const std::string library : {"sim", "eval"})
  {
    if (after.find("`" + library + "`") == std::string::npos)
      throw std::runtime_error(std::string(kPage) + ": no `" + library +
                               "` after the table of rooms");
    m_names.push_back(library);
  }
  if (std::set<std::string>(m_names.begin(), m_names.end()).size() != m_names.size())
    throw std::runtime_error(std::string(kPage) + ": a room stands twice in the table");
}

bool Floors::has(const std::string& room) const
{
  return std::find(m_names.begin(), m_names.end(), room) != m_names.end();
}

bool Floors::mayInclude(const std::string& room, const std::string& other) const
{
  const auto floor = [this](const std::string& name)
  { return std::find(m_names.begin(), m_names.end(), name); };
  return has(other) && floor(other) <= floor(room);
}

Complaints complaintsAboutLibrary(const fs::path& root, const Floors& floors)
{
  Complaints all;
  for (const char* folder : {"mrpt_mapconv/include/mrpt_mapconv", "mrpt_mapconv/src"})
    for (std::string& complaint : RoomFolder(root, folder, floors).complaints())
      all.push_back(std::move(complaint));
  return all;
}

}  // namespace mrpt_mapconv::house
