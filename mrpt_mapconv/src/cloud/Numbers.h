#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace mrpt_mapconv::cloud
{
/** Binary numbers in files of points. */
enum class NumberType : std::uint8_t
{
  Int8,
  Uint8,
  Int16,
  Uint16,
  Int32,
  Uint32,
  Int64,
  Uint64,
  Float32,
  Float64
};

/** In bytes. */
constexpr std::size_t sizeOf(NumberType type)
{
  constexpr std::array<std::size_t, 10> kSizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

/** A number at any address, in the byte order of the machine: little endian, as are all that the
 * library is built for. */
template <class Number>
Number numberAt(const char* bytes)
{
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

template <class Number>
void appendNumber(std::string& bytes, Number number)
{
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof number);
  std::memcpy(&bytes[at], &number, sizeof number);
}

/** \param bigEndian whether the first byte is the most significant one */
inline double numberAt(const char* bytes, NumberType type, bool bigEndian = false)
{
  std::array<char, 8> turned{};
  if (bigEndian)
  {
    std::reverse_copy(bytes, bytes + sizeOf(type), turned.data());
    bytes = turned.data();
  }
  switch (type)
  {
    case NumberType::Int8:
      return numberAt<std::int8_t>(bytes);
    case NumberType::Uint8:
      return numberAt<std::uint8_t>(bytes);
    case NumberType::Int16:
      return numberAt<std::int16_t>(bytes);
    case NumberType::Uint16:
      return numberAt<std::uint16_t>(bytes);
    case NumberType::Int32:
      return numberAt<std::int32_t>(bytes);
    case NumberType::Uint32:
      return numberAt<std::uint32_t>(bytes);
    case NumberType::Int64:
      return static_cast<double>(numberAt<std::int64_t>(bytes));
    case NumberType::Uint64:
      return static_cast<double>(numberAt<std::uint64_t>(bytes));
    case NumberType::Float32:
      return static_cast<double>(numberAt<float>(bytes));
    case NumberType::Float64:
      return numberAt<double>(bytes);
  }
  return 0;
}

}  // namespace mrpt_mapconv::cloud
