#pragma once

#include <set>
#include <string>
#include <vector>

namespace mrpt_mapconv::files
{
/** The output folder of a command, in which every file appears whole or not at all.
 *
 * Files are written into a hidden staging folder inside the output folder, so that commit() can
 * rename them into place (the same file system). Without commit() nothing is left behind: neither
 * the staged files nor folders that were created for them.
 *
 * \code
 * OutputDir out("maps");
 * writeGeoTiff(out.path("layers.tif"), bands);
 * out.commit();
 * \endcode
 */
class OutputDir
{
 public:
  /** Creates the folder, with its parents, unless it is there.
   * \exception std::runtime_error naming the path and the reason if it cannot be created, is a file
   * or cannot be written to */
  explicit OutputDir(const std::string& dir);
  ~OutputDir();
  OutputDir(const OutputDir&) = delete;
  OutputDir& operator=(const OutputDir&) = delete;

  const std::string& dir() const { return m_dir; }

  /** Where to write the output file `name`; commit() then expects it there.
   * \param name a file name without folders
   * \exception std::invalid_argument for a name with folders or an empty one */
  std::string path(const std::string& name);

  /** Moves every staged file to its place, replacing older ones; ends the staging.
   * \exception std::runtime_error naming the file and the reason if an output is missing, was not
   * written completely or cannot replace what lies at its place; what has not yet been moved by
   * then never appears */
  void commit();

  /** Removes what is staged and the folders that were created for it; nothing after commit(). */
  void discard() noexcept;

 private:
  std::vector<std::string> stagedNames() const;
  void checkStaged(const std::vector<std::string>& names) const;
  void createDir();
  void removeCreated();

  std::string m_dir;
  std::string m_staging;
  std::set<std::string> m_expected;
  std::vector<std::string> m_created;  //!< folders created by us, outermost first
};

/** A message in which the paths of staged files are those that the files were to get. */
std::string withoutStaging(const std::string& message);

}  // namespace mrpt_mapconv::files
