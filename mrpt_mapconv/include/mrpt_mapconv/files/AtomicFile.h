#pragma once

#include <mrpt_mapconv/files/OutputDir.h>

#include <optional>
#include <string>

namespace mrpt_mapconv::files
{
/** A single output file that appears whole or not at all: OutputDir for one file.
 *
 * A symbolic link is followed, so that the file it names is replaced and not the link. Devices and
 * pipes (/dev/stdout, …) cannot be renamed onto; they are written directly.
 */
class AtomicFile
{
 public:
  /** \exception std::runtime_error naming the path and the reason if its folder cannot be created
   * or written to, or if the path is a folder */
  explicit AtomicFile(const std::string& path);

  /** Where to write the file; keeps the file's name and extension. */
  const std::string& stagingPath() const { return m_stagingPath; }

  /** The folder in which it is staged; null if it is written directly. */
  OutputDir* folder() { return m_folder ? &*m_folder : nullptr; }

  /** Moves the written file to its place. \exception std::runtime_error as OutputDir::commit() */
  void commit();

 private:
  std::optional<OutputDir> m_folder;  //!< none: written directly
  std::string m_stagingPath;
};

}  // namespace mrpt_mapconv::files
