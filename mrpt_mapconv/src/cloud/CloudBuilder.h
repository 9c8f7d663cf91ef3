#pragma once

#include <mrpt_mapconv/cloud/CloudFields.h>
#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/params/MemoryLimit.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace mrpt_mapconv::cloud
{
/** What a file says of one point, by Field. */
using Row = std::array<double, kFields>;

/** Collects the points of a file, whatever its format. */
class CloudBuilder
{
 public:
  /** \param name of the file, for messages
   * \param fields that its points have
   * \param memory that the cloud may take [bytes] */
  CloudBuilder(std::string name, FieldSet fields, std::size_t memory = params::memoryLimit());

  /** Room for as many points as the file has bytes for, at most as many as its header promises.
   * \exception std::runtime_error naming the file and what they need, if that is too much */
  void reserve(std::uint64_t promised, const std::optional<std::uintmax_t>& fileSize,
               std::size_t bytesPerPoint);
  /** Adds a point, unless one of its coordinates is no finite number.
   * \exception std::runtime_error naming the file, the point and the value, where one of whole
   * numbers of 0 to 255 is none; or naming what memory the points need, if it is too much */
  void add(const Row& row);
  /** Points that were added or left out. */
  std::size_t seen() const { return m_cloud.size() + m_cloud.notFinite; }

  /** The cloud in metres, less its origin.
   * \param named what the file says of the units of its coordinates
   * \exception std::runtime_error naming the file, if no point is left */
  PointCloud finished(const CloudReading& reading,
                      const std::optional<grid::SystemUnits>& named = {}) &&;

 private:
  void requireMemoryFor(std::size_t points, const char* orMore) const;
  [[noreturn]] void refuse(const char* field, double value) const;

  std::string m_name;
  FieldSet m_fields;
  std::size_t m_memory, m_bytesPerPoint = 0, m_mostPoints = 0;
  PointCloud m_cloud;
};

}  // namespace mrpt_mapconv::cloud
