#include "LasHeader.h"

#include <mrpt_mapconv/params/Text.h>

#include <cmath>

#include "Numbers.h"

namespace mrpt_mapconv::cloud
{
namespace
{
constexpr std::size_t kShortHeader = 227;
constexpr int kFormats = 11;
constexpr std::array<LasPointLayout, kFormats> kLayouts = {{{20, 0, true},
                                                            {28, 20, true},
                                                            {26, 0, true},
                                                            {34, 20, true},
                                                            {57, 20, true},
                                                            {63, 20, true},
                                                            {30, 22, false},
                                                            {36, 22, false},
                                                            {38, 22, false},
                                                            {59, 22, false},
                                                            {67, 22, false}}};

template <class Number>
Number field(const LasHeader& header, std::size_t at)
{
  return numberAt<Number>(header.bytes.data() + at);
}

/** Takes the header's bytes, which say themselves how many they are. */
void takeBytes(BlockInput& input, LasHeader& header)
{
  header.bytes = input.bytes(kShortHeader);
  if (header.bytes.size() < kShortHeader || header.bytes.compare(0, 4, "LASF") != 0)
    input.fail("is cut off within the header of a .las");
  const int major = field<std::uint8_t>(header, las_at::kMajor);
  header.minor = field<std::uint8_t>(header, las_at::kMinor);
  if (major != 1 || header.minor > 4)
    input.fail("is LAS " + std::to_string(major) + "." + std::to_string(header.minor) +
               "; versions 1.0 to 1.4 are read");
  const std::size_t size = field<std::uint16_t>(header, las_at::kHeaderSize);
  const std::size_t least = header.minor == 4 ? kLasHeader14 : kShortHeader;
  if (size < least)
    input.fail("its header says to have " + std::to_string(size) + " bytes; in LAS 1." +
               std::to_string(header.minor) + " it has " + std::to_string(least) + " at least");
  header.bytes += input.bytes(size - kShortHeader);
  if (header.bytes.size() < size) input.fail("is cut off within the header of a .las");
}

void readCounts(LasHeader& header)
{
  const auto encoding = field<std::uint16_t>(header, las_at::kEncoding);
  header.wkt = (encoding & kLasWkt) != 0;
  header.adjustedTime = (encoding & kLasAdjustedTime) != 0;
  header.pointsAt = field<std::uint32_t>(header, las_at::kPointsAt);
  header.records = field<std::uint32_t>(header, las_at::kRecords);
  header.pointFormat = field<std::uint8_t>(header, las_at::kPointFormat);
  header.pointSize = field<std::uint16_t>(header, las_at::kPointSize);
  header.points = field<std::uint32_t>(header, las_at::kOldCount);
  if (header.minor < 4) return;
  header.lateRecordsAt = field<std::uint64_t>(header, las_at::kLateRecordsAt);
  header.lateRecords = field<std::uint32_t>(header, las_at::kLateRecords);
  if (const auto points = field<std::uint64_t>(header, las_at::kCount); points > 0)
    header.points = points;
}

void checkPoints(const BlockInput& input, const LasHeader& header)
{
  if (header.pointFormat >= kFormats)
    input.fail("its points are of the unknown format " + std::to_string(header.pointFormat) +
               "; LAS has 0 to 10");
  const std::size_t least = lasPointLayout(header.pointFormat).size;
  if (header.pointSize < least)
    input.fail("its points say to have " + std::to_string(header.pointSize) +
               " bytes each; those of format " + std::to_string(header.pointFormat) + " have " +
               std::to_string(least) + " at least");
  if (header.pointsAt < header.bytes.size())
    input.fail("its points say to begin at byte " + std::to_string(header.pointsAt) +
               ", within the header of " + std::to_string(header.bytes.size()) + " bytes");
  if (header.points == 0) input.fail("holds no point");
}

/** A coordinate is a whole number of 32 bits times scale plus offset. */
void readScales(const BlockInput& input, LasHeader& header)
{
  constexpr double kFarthest = 1e12, kIntegers = 2147483648.0;  // [m]; a tenth of a mm there
  for (std::size_t i = 0; i < 3; ++i)
  {
    header.scale[i] = field<double>(header, las_at::kScale + i * sizeof(double));
    header.offset[i] = field<double>(header, las_at::kOffset + i * sizeof(double));
    const std::string axis(1, "xyz"[i]);
    const auto refuse = [&](const char* what, double value, const char* right)
    {
      input.fail(what + (" of " + axis) + " = " + params::shortestText(value) +
                 " is not valid: it must be " + right);
    };
    if (!(header.scale[i] > 0) || header.scale[i] * kIntegers > kFarthest)
      refuse("scale", header.scale[i], "> 0 and at most 400 m");
    if (!(std::abs(header.offset[i]) <= kFarthest))
      refuse("offset", header.offset[i], "within 1e12 m of 0");
  }
}
}  // namespace

const LasPointLayout& lasPointLayout(int pointFormat)
{
  return kLayouts.at(static_cast<std::size_t>(pointFormat));
}

LasHeader readLasHeader(BlockInput& input)
{
  LasHeader header;
  takeBytes(input, header);
  readCounts(header);
  checkPoints(input, header);
  readScales(input, header);
  return header;
}

}  // namespace mrpt_mapconv::cloud
