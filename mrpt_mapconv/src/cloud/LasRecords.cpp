#include "LasRecords.h"

#include <mrpt_mapconv/params/Text.h>

#include <limits>

#include "Numbers.h"

namespace mrpt_mapconv::cloud
{
namespace
{
constexpr std::size_t kUserAt = 2, kUserSize = 16, kIdAt = 18, kLengthAt = 20, kDescription = 32;
constexpr std::size_t kHead = 54, kLateHead = 60;
constexpr const char* kProjection = "LASF_Projection";
constexpr std::uint16_t kGeoKeys = 34735, kWkt = 2112;
constexpr std::uint16_t kModelType = 1024, kProjected = 3072, kGeographic = 2048,
                        kLinearUnits = 3076, kVerticalUnits = 4099, kUserDefined = 32767;

std::optional<grid::SystemKind> kindOf(std::uint16_t modelType)
{
  switch (modelType)
  {
    case 1:
      return grid::SystemKind::Plane;
    case 2:
      return grid::SystemKind::Geographic;
    case 3:
      return grid::SystemKind::Geocentric;
    default:
      return std::nullopt;
  }
}

/** A unit by its number in EPSG's list [m]; nothing for those of which nobody makes surveys. */
std::optional<double> lengthOf(std::uint16_t epsg)
{
  switch (epsg)
  {
    case 9001:
      return 1;
    case 9002:
      return grid::kFoot;
    case 9003:
      return grid::kSurveyFoot;
    default:
      return std::nullopt;
  }
}

/** Keys of GeoTIFF: four numbers of 16 bits each, after four that say how many there are. */
void readKeys(const std::string& keys, LasProjection& projection)
{
  constexpr std::size_t kKey = 4 * sizeof(std::uint16_t);
  std::uint16_t projected = 0, geographic = 0;
  for (std::size_t at = kKey; at + kKey <= keys.size(); at += kKey)
  {
    const auto number = [&](std::size_t i)
    { return numberAt<std::uint16_t>(keys.data() + at + i * sizeof(std::uint16_t)); };
    const bool isHere = number(1) == 0;  // the value itself, not a place where it is
    if (!isHere || number(3) == kUserDefined) continue;
    if (number(0) == kProjected) projected = number(3);
    if (number(0) == kGeographic) geographic = number(3);
    if (number(0) == kModelType) projection.kind = kindOf(number(3));
    if (number(0) == kLinearUnits) projection.horizontal = lengthOf(number(3));
    if (number(0) == kVerticalUnits) projection.vertical = lengthOf(number(3));
  }
  // a projection without a number has a geographic system below it, which is not that of the points
  const bool isPlane = projection.kind == grid::SystemKind::Plane;
  const std::uint16_t code = projected != 0 || isPlane ? projected : geographic;
  projection.epsg = code == 0 ? "" : "EPSG:" + std::to_string(code);
}

/** Up to its closing zeros, line ends and blanks. */
std::string textOf(const std::string& bytes)
{
  return params::trimmed(bytes.substr(0, bytes.find('\0')));
}

[[noreturn]] void failRecord(const BlockInput& input, std::uint32_t index, std::uint32_t count)
{
  input.fail("its record " + std::to_string(index + 1) + " of " + std::to_string(count) +
             " (of variable length) is cut off");
}

/** Takes one record, and keeps what it says of the projection. \return false if it is cut off, or
 * goes beyond `end` */
bool readRecord(BlockInput& input, bool isLate, std::uint64_t end, LasProjection& projection)
{
  constexpr std::uint64_t kLongestText = 1U << 20U;
  const std::size_t headSize = isLate ? kLateHead : kHead;
  if (end - input.position() < headSize) return false;
  const char* head = input.take(headSize);
  if (!head) return false;
  const std::string user(head + kUserAt, kUserSize);
  const auto id = numberAt<std::uint16_t>(head + kIdAt);
  const std::uint64_t length = isLate ? numberAt<std::uint64_t>(head + kLengthAt)
                                      : numberAt<std::uint16_t>(head + kLengthAt);
  if (length > end - input.position()) return false;
  const bool isProjection = textOf(user) == kProjection && (id == kGeoKeys || id == kWkt);
  if (!isProjection || length > kLongestText) return input.skip(length);
  const std::string payload = input.bytes(length);
  if (id == kWkt) projection.wkt = textOf(payload);
  if (id == kGeoKeys) readKeys(payload, projection);
  return payload.size() == length;
}

std::string record(std::uint16_t id, const std::string& payload)
{
  std::string bytes(kUserAt, '\0');
  bytes += kProjection;
  bytes.resize(kIdAt, '\0');
  appendNumber(bytes, id);
  appendNumber(bytes, static_cast<std::uint16_t>(payload.size()));
  bytes.resize(bytes.size() + kDescription, '\0');
  return bytes + payload;
}
}  // namespace

std::optional<grid::SystemUnits> LasProjection::units(bool preferWkt) const
{
  auto units = grid::unitsOf(text(preferWkt));
  if (prefersWkt(preferWkt) && units) return units;
  if (!units && !kind && !horizontal && !vertical) return std::nullopt;
  if (!units) units = grid::SystemUnits{kind.value_or(grid::SystemKind::Plane), 1, {}};
  units->horizontal = horizontal.value_or(units->horizontal);
  if (vertical) units->vertical = vertical;
  return units;
}

void readRecords(BlockInput& input, const LasHeader& header, LasProjection& projection)
{
  for (std::uint32_t i = 0; i < header.records; ++i)
    if (!readRecord(input, false, header.pointsAt, projection))
      failRecord(input, i, header.records);
  if (!input.skip(header.pointsAt - input.position())) input.failTruncated(header.points, 0);
}

void readLateRecords(BlockInput& input, const LasHeader& header, LasProjection& projection)
{
  if (header.lateRecords == 0) return;
  if (header.lateRecordsAt < input.position() ||
      !input.skip(header.lateRecordsAt - input.position()))
    failRecord(input, 0, header.lateRecords);
  for (std::uint32_t i = 0; i < header.lateRecords; ++i)
    if (!readRecord(input, true, std::numeric_limits<std::uint64_t>::max(), projection))
      failRecord(input, i, header.lateRecords);
}

std::string projectionRecord(const std::string& coordinateSystem)
{
  constexpr std::string_view kEpsg = "EPSG:";
  constexpr std::size_t kLongest = 0xFFFF - 1;
  if (coordinateSystem.empty() || coordinateSystem.size() > kLongest) return "";
  std::uint16_t code = 0;
  if (coordinateSystem.compare(0, kEpsg.size(), kEpsg) != 0 ||
      !params::readWhole(std::string_view(coordinateSystem).substr(kEpsg.size()), code))
    return record(kWkt, coordinateSystem + '\0');
  std::string keys;
  constexpr std::uint16_t kIsProjected = 1;
  for (const std::uint16_t number :
       {std::uint16_t(1), std::uint16_t(1), std::uint16_t(0), std::uint16_t(2), kModelType,
        std::uint16_t(0), std::uint16_t(1), kIsProjected, kProjected, std::uint16_t(0),
        std::uint16_t(1), code})
    appendNumber(keys, number);
  return record(kGeoKeys, keys);
}

bool holdsWkt(const std::string& record)
{
  return record.size() > kHead && numberAt<std::uint16_t>(record.data() + kIdAt) == kWkt;
}

}  // namespace mrpt_mapconv::cloud
