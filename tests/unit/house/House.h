#pragma once

#include <filesystem>
#include <string>
#include <vector>

/** What share/doc/architecture.md says of the source tree, and where the tree departs from it. */
namespace mrpt_mapconv::house
{
/** The floors of the house, ground floor first: the rooms of the library in the order of the page's
 * table, then `sim` and `eval`. A floor may be described before it is built. */
class Floors
{
 public:
  static constexpr const char* kPage = "share/doc/architecture.md";

  /** Reads the table below the heading "Rooms of the library", whose rows begin "| `room` |", and
   * what follows it.
   * \exception std::runtime_error naming the page if it is missing, has no such table, a room
   * twice, or does not name `sim` and `eval` after it */
  explicit Floors(const std::filesystem::path& root);
  explicit Floors(std::vector<std::string> names) : m_names(std::move(names)) {}

  bool has(const std::string& room) const;
  /** Whether a file of `room` may include one of `other`: it is the same or a lower one. */
  bool mayInclude(const std::string& room, const std::string& other) const;

 private:
  std::vector<std::string> m_names;
};

/** Complaints, one line each, that name the file and what is wrong with it. */
using Complaints = std::vector<std::string>;

/** Folders of the library that are no room; includes that lead up, to no room or to no header of
 * ours; namespaces that are not the folder's, but for the map classes in `maps`, which stand in
 * mrpt_mapconv itself. */
Complaints complaintsAboutLibrary(const std::filesystem::path& root, const Floors& floors);

/** Entries of the top level that have no place there; folders and files of apps that are not
 * command, input, output or experiment; subcommands that do not have a file of their name, alone;
 * includes of the program that do not go down from command to experiment to input to output, or
 * from input to more than output's Console, Json and Progress;
 * folders of config that are neither worlds, experiments nor a class that is registered with MRPT;
 * folders of tests/unit that are no room; tests that are built with the program's sources. */
Complaints complaintsAboutFolders(const std::filesystem::path& root, const Floors& floors);

}  // namespace mrpt_mapconv::house
