#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mrpt_mapconv::testing
{
template <class Number>
void putAt(std::string& bytes, std::size_t at, Number number)
{
  if (bytes.size() < at + sizeof number) bytes.resize(at + sizeof number, '\0');
  std::memcpy(&bytes[at], &number, sizeof number);
}

/** A `.las` made by hand, from the tables of the specification. */
struct LasBytes
{
  int minor = 2, format = 0;
  std::uint16_t encoding = 0, pointSize = 0;  //!< 0: as the format has it
  std::array<double, 3> scale{0.01, 0.01, 0.01}, offset{0, 0, 0};
  std::string points;  //!< see add()
  std::uint64_t count = 0;
  std::string records, lateRecords;  //!< see record(), lateRecord()
  std::uint32_t recordCount = 0, lateCount = 0;

  static std::uint16_t sizeOf(int format)
  {
    constexpr std::array<std::uint16_t, 11> kSizes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    return kSizes.at(static_cast<std::size_t>(format));
  }
  std::uint16_t size() const { return pointSize > 0 ? pointSize : sizeOf(format); }

  /** A point whose other bytes are 0. */
  std::string& add(std::int32_t x, std::int32_t y, std::int32_t z)
  {
    std::string point(size(), '\0');
    putAt(point, 0, x);
    putAt(point, 4, y);
    putAt(point, 8, z);
    points += point;
    ++count;
    return points;
  }
  /** Changes the last point. */
  template <class Number>
  void set(std::size_t at, Number number)
  {
    putAt(points, points.size() - size() + at, number);
  }

  void record(const std::string& user, std::uint16_t id, const std::string& payload)
  {
    std::string bytes(54, '\0');
    bytes.replace(2, user.size(), user);
    putAt(bytes, 18, id);
    putAt(bytes, 20, static_cast<std::uint16_t>(payload.size()));
    records += bytes + payload;
    ++recordCount;
  }
  void lateRecord(const std::string& user, std::uint16_t id, const std::string& payload)
  {
    std::string bytes(60, '\0');
    bytes.replace(2, user.size(), user);
    putAt(bytes, 18, id);
    putAt(bytes, 20, static_cast<std::uint64_t>(payload.size()));
    lateRecords += bytes + payload;
    ++lateCount;
  }

  std::string bytes() const
  {
    const std::uint16_t headerSize = minor == 4 ? 375 : minor == 3 ? 235 : 227;
    std::string file(headerSize, '\0');
    file.replace(0, 4, "LASF");
    putAt(file, 6, encoding);
    putAt(file, 24, std::uint8_t(1));
    putAt(file, 25, static_cast<std::uint8_t>(minor));
    putAt(file, 94, headerSize);
    putAt(file, 96, static_cast<std::uint32_t>(headerSize + records.size()));
    putAt(file, 100, recordCount);
    putAt(file, 104, static_cast<std::uint8_t>(format));
    putAt(file, 105, size());
    putAt(file, 107, static_cast<std::uint32_t>(format > 5 ? 0 : count));
    for (std::size_t i = 0; i < 3; ++i)
    {
      putAt(file, 131 + 8 * i, scale.at(i));
      putAt(file, 155 + 8 * i, offset.at(i));
    }
    if (minor == 4)
    {
      putAt(file, 235, static_cast<std::uint64_t>(headerSize + records.size() + points.size()));
      putAt(file, 243, lateCount);
      putAt(file, 247, count);
    }
    return file + records + points + lateRecords;
  }
};

/** GeoTIFF's keys, with their values. */
inline std::string geoKeys(const std::vector<std::pair<std::uint16_t, std::uint16_t>>& keys)
{
  std::string bytes;
  const auto add = [&bytes](std::uint16_t number) { putAt(bytes, bytes.size(), number); };
  for (const auto number : {std::size_t(1), std::size_t(1), std::size_t(0), keys.size()})
    add(static_cast<std::uint16_t>(number));
  for (const auto& [key, value] : keys)
    for (const std::uint16_t number : {key, std::uint16_t(0), std::uint16_t(1), value}) add(number);
  return bytes;
}
/** Those of a projection, one of which is `key` = `value`. */
inline std::string geoKeys(std::uint16_t key, std::uint16_t value)
{
  return geoKeys({{1024, 1}, {key, value}});
}

}  // namespace mrpt_mapconv::testing
