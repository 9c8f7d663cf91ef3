#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <mrpt_mapconv/params/Fields.h>

#include <ostream>
#include <stdexcept>
#include <string>

namespace mrpt_mapconv::params
{
/** Options of a map class as MRPT loads, saves, prints and streams them, from the list of their
 * fields (see Fields.h). `struct TMyOptions : params::ListedOptions<TMyOptions>` has, besides its
 * fields, visit() and check():
 * \code
 * static constexpr const char* kName = "TMyOptions";      // for people
 * static constexpr const char* kStreamName = "my options";  // likewise, in errors
 * static constexpr std::uint8_t kStreamVersion = 0;       // one more with each new field
 * \endcode
 * Fields that a stream is too old for get their values from ofOlderFiles(), which Options may have
 * of its own. */
template <class Options>
struct ListedOptions : public mrpt::config::CLoadableOptions
{
  /** Reads the keys that are there, strictly; warns about others.
   * \exception std::runtime_error naming section, key and value; the options then stay as they were
   */
  void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                          const std::string& section) override
  {
    StrictSection ini(source, section);
    Options read = self();
    readFields(ini, read);
    ini.checked([&read] { read.check(); });
    ini.warnUnknown();
    self() = read;
  }

  /** Numbers are written such that they read the same. */
  void saveToConfigFile(mrpt::config::CConfigFileBase& target,
                        const std::string& section) const override
  {
    saveFields(self(), target, section);
  }

  void dumpToTextStream(std::ostream& out) const override
  {
    out << "\n----------- [mrpt_mapconv " << Options::kName << "] ------------ \n\n";
    printFields(self(), out);
  }

  void writeToStream(mrpt::serialization::CArchive& out) const
  {
    out << Options::kStreamVersion;
    writeFields(self(), out);
  }

  /** Reads a stream of this version or an older one. Values are not checked: a stream brings back
   * what was written, valid or not.
   * \exception std::exception for a stream that ends, is newer or does not hold these options */
  void readFromStream(mrpt::serialization::CArchive& in)
  {
    std::uint8_t version = 0;
    in >> version;
    if (version > Options::kStreamVersion)
      throw std::runtime_error(std::string(Options::kStreamName) + ": unknown version " +
                               std::to_string(version));
    Options read = Options::ofOlderFiles();
    readFields(in, read, version, Options::kStreamName);
    self() = read;
  }

  static Options ofOlderFiles() { return {}; }

 private:
  Options& self() { return static_cast<Options&>(*this); }
  const Options& self() const { return static_cast<const Options&>(*this); }
};

}  // namespace mrpt_mapconv::params
