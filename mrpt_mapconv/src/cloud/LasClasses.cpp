#include <mrpt_mapconv/cloud/LasClasses.h>
#include <mrpt_mapconv/files/AtomicFile.h>

#include <algorithm>
#include <limits>

#include "BlockInput.h"
#include "LasHeader.h"
#include "OutputFile.h"

namespace mrpt_mapconv::cloud
{
namespace
{
/** Copies bytes as they are. \return how many there were */
std::uint64_t copyBytes(BlockInput& input, std::uint64_t most, OutputFile& file)
{
  constexpr std::uint64_t kBlock = 1U << 20U;
  std::uint64_t copied = 0;
  while (copied < most)
  {
    const std::string bytes = input.bytes(std::min(kBlock, most - copied));
    if (bytes.empty()) break;
    file.bytes() += bytes;
    file.writeBlock();
    copied += bytes.size();
  }
  return copied;
}

void setClass(char* point, const LasPointLayout& layout, std::uint8_t value)
{
  if ((static_cast<unsigned char>(point[LasPointLayout::kFlags]) & layout.withheldBit()) != 0)
    return;
  char& byte = point[layout.classAt()];
  const unsigned kept = layout.isOld ? static_cast<unsigned char>(byte) & ~kOldClassBits : 0;
  byte = static_cast<char>(kept | value);
}

void checkClasses(const BlockInput& input, const LasHeader& header,
                  const std::vector<std::uint8_t>& classes)
{
  if (classes.size() != header.points)
    input.fail("has " + std::to_string(header.points) + " points for " +
               std::to_string(classes.size()) + " classes");
  const auto largest = std::max_element(classes.begin(), classes.end());
  if (lasPointLayout(header.pointFormat).isOld && *largest > kOldClassBits)
    input.fail("its point format " + std::to_string(header.pointFormat) +
               " has classes of 0 to 31, not " + std::to_string(*largest));
}
}  // namespace

void copyLasWithClasses(const std::string& from, const std::string& to,
                        const std::vector<std::uint8_t>& classes)
{
  files::InputStream stream(from);
  BlockInput input(stream);
  const LasHeader header = readLasHeader(input);
  checkClasses(input, header, classes);
  files::AtomicFile atomic(to);
  OutputFile file(atomic.stagingPath());
  file.bytes() = header.bytes;
  const std::uint64_t between = header.pointsAt - header.bytes.size();
  if (copyBytes(input, between, file) < between) input.failTruncated(header.points, 0);

  const LasPointLayout& layout = lasPointLayout(header.pointFormat);
  for (std::uint64_t i = 0; i < header.points; ++i)
  {
    const char* point = input.take(header.pointSize);
    if (!point) input.failTruncated(header.points, i);
    const std::size_t at = file.bytes().size();
    file.bytes().append(point, header.pointSize);
    setClass(&file.bytes()[at], layout, classes[static_cast<std::size_t>(i)]);
    file.writeBlock();
  }
  copyBytes(input, std::numeric_limits<std::uint64_t>::max(), file);
  file.close();
  atomic.commit();
}

}  // namespace mrpt_mapconv::cloud
