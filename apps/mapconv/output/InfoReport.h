#pragma once

#include <mrpt_mapconv/files/InputStream.h>

#include <string>

#include "output/Json.h"

namespace mapconv
{
/** What `info` has found out about a file, as text for a person and as JSON. */
class InfoReport
{
 public:
  JsonObject json;

  /** Adds a line "label   text". */
  void line(const std::string& label, const std::string& text);
  const std::string& text() const { return m_text; }

 private:
  std::string m_text;
};

/** Describes an OctoMap file. */
void describeOctreeFile(mrpt_mapconv::files::InputStream& stream, InfoReport& report);
/** Describes a file of points. \param columns see cloud::CloudReading */
void describeCloudFile(mrpt_mapconv::files::InputStream& stream, const std::string& columns,
                       InfoReport& report);
/** Describes a file of MRPT objects: rawlog, simplemap, or maps. */
void describeObjectFile(mrpt_mapconv::files::InputStream stream, InfoReport& report);

}  // namespace mapconv
