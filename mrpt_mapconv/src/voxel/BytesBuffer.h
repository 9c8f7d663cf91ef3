#pragma once

#include <algorithm>
#include <cstring>
#include <streambuf>
#include <string_view>

namespace mrpt_mapconv::voxel
{
/** A stream buffer over bytes that stay where they are: a std::istringstream would copy them. */
class BytesBuffer : public std::streambuf
{
 public:
  explicit BytesBuffer(std::string_view bytes) : m_bytes(bytes) {}

 protected:
  std::streamsize xsgetn(char* to, std::streamsize wanted) override
  {
    const auto n = std::min(static_cast<std::size_t>(wanted), m_bytes.size());
    std::memcpy(to, m_bytes.data(), n);
    m_bytes.remove_prefix(n);
    return static_cast<std::streamsize>(n);
  }

 private:
  std::string_view m_bytes;
};

}  // namespace mrpt_mapconv::voxel
