#pragma once

#include <gtest/gtest.h>
#include <mrpt_mapconv/cloud/CloudFile.h>

#include <cstring>
#include <string>

#include "support/TempDir.h"

namespace mrpt_mapconv::testing
{
/** The cloud in a file of these bytes. */
inline cloud::PointCloud readBytesAs(const std::string& name, const std::string& bytes,
                                     const cloud::CloudReading& reading = {})
{
  const TempDir dir;
  std::ofstream(dir.path(name), std::ios::binary) << bytes;
  return cloud::readCloudFile(dir.path(name), reading);
}

/** One line that names the file and holds these words. */
inline void expectRefused(const std::string& name, const std::string& bytes,
                          const std::string& words, const cloud::CloudReading& reading = {})
{
  const auto message = messageOf([&] { readBytesAs(name, bytes, reading); });
  EXPECT_TRUE(contains(message, words)) << words << " in: " << message;
  EXPECT_TRUE(contains(message, name + ": ")) << message;
  EXPECT_FALSE(contains(message, "\n")) << message;
}

template <class Number>
std::string bytesOf(Number number)
{
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

}  // namespace mrpt_mapconv::testing
