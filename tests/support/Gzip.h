#pragma once

#include <mrpt/io/CFileGZOutputStream.h>

#include <stdexcept>
#include <string>

namespace mrpt_mapconv::testing
{
/** Writes bytes into a gzipped file. */
inline void writeGzipped(const std::string& path, const std::string& bytes)
{
  mrpt::io::CFileGZOutputStream file;
  if (!file.open(path) || file.Write(bytes.data(), bytes.size()) != bytes.size())
    throw std::runtime_error("cannot write " + path);
}
}  // namespace mrpt_mapconv::testing
