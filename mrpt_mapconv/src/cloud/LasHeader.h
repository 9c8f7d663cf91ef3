#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "BlockInput.h"

namespace mrpt_mapconv::cloud
{
/** The public header block of a `.las` file ("LAS Specification 1.4 - R15", table 3). */
struct LasHeader
{
  std::string bytes;                //!< the whole of it, as it stands in the file
  int minor = 0;                    //!< of version 1.minor
  bool wkt = false;                 //!< whether its coordinate system is given as WKT
  bool adjustedTime = false;        //!< whether times are adjusted GPS time, not of the GPS week
  std::uint64_t pointsAt = 0;       //!< first byte of the points
  std::uint32_t records = 0;        //!< variable length records before the points
  std::uint64_t lateRecordsAt = 0;  //!< first byte of those behind the points
  std::uint32_t lateRecords = 0;
  int pointFormat = 0;
  std::size_t pointSize = 0;  //!< [bytes]
  std::uint64_t points = 0;
  std::array<double, 3> scale{}, offset{};
};

/** First bytes of the header's fields. */
namespace las_at
{
constexpr std::size_t kEncoding = 6, kMajor = 24, kMinor = 25, kSystem = 26, kSoftware = 58,
                      kHeaderSize = 94, kPointsAt = 96, kRecords = 100, kPointFormat = 104,
                      kPointSize = 105, kOldCount = 107, kOldReturns = 111, kScale = 131,
                      kOffset = 155, kLimits = 179, kLateRecordsAt = 235, kLateRecords = 243,
                      kCount = 247, kReturns = 255;
}  // namespace las_at
constexpr std::size_t kLasHeader14 = 375;    //!< bytes of a header of version 1.4
constexpr unsigned kLasAdjustedTime = 0x01;  //!< in kEncoding: times are adjusted GPS time
constexpr unsigned kLasWkt = 0x10;           //!< in kEncoding: the coordinate system is WKT

/** Where the fields of a point are, by its format (the same, tables 7 to 17). */
struct LasPointLayout
{
  std::size_t size;    //!< [bytes] at least; programs may add fields of their own
  std::size_t timeAt;  //!< 0: has no time
  bool isOld;          //!< formats 0 to 5: five bits of class, three of returns

  static constexpr std::size_t kX = 0, kIntensity = 12, kReturns = 14, kFlags = 15;
  std::size_t classAt() const { return isOld ? kFlags : 16; }
  unsigned withheldBit() const { return isOld ? 0x80U : 0x04U; }
};
constexpr unsigned kOldClassBits = 0x1F;
/** \param pointFormat 0 to 10 */
const LasPointLayout& lasPointLayout(int pointFormat);

/** Reads and checks it. \exception std::runtime_error naming the file, field and value */
LasHeader readLasHeader(BlockInput& input);

}  // namespace mrpt_mapconv::cloud
