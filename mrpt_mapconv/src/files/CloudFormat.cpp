#include <mrpt_mapconv/files/CloudFormat.h>
#include <mrpt_mapconv/files/FileIo.h>

#include <algorithm>

#include "OtherKind.h"
#include "TextBytes.h"

namespace mrpt_mapconv::files
{
namespace
{
using namespace std::string_view_literals;

bool isPly(std::string_view begin)
{
  return beginsWith(begin, "ply\n") || beginsWith(begin, "ply\r");
}

/** LAS that is not packed to LAZ, which says so in the point format. */
bool isLas(std::string_view begin) { return beginsWith(begin, "LASF") && !isPackedLas(begin); }

/** PCL's header, which may have other comments than PCL writes, and any line ends. */
bool isPcd(std::string_view begin)
{
  const bool hasFields = hasLine(begin, "FIELDS ") || hasLine(begin, "COLUMNS ");
  return beginsWith(begin, "# .PCD") || (hasLine(begin, "VERSION ") && hasFields);
}

/** KITTI's scans are four floats a point and nothing else. */
bool isKittiScan(const FileTraits& file)
{
  constexpr std::uintmax_t kPoint = 4 * sizeof(float);
  return endingOf(file.name) == ".bin" && file.size.value_or(0) > 0 && *file.size % kPoint == 0 &&
         !beginsAsObject(file.begin);
}

bool isTextOfPoints(const FileTraits& file)
{
  const std::string ending = endingOf(file.name);
  const auto endings = {".xyz", ".txt", ".asc", ".pts", ".csv"};
  return std::find(endings.begin(), endings.end(), ending) != endings.end() &&
         file.begin.find('\0') == std::string_view::npos && !beginsAsObject(file.begin);
}
}  // namespace

std::optional<CloudFormat> cloudFormatOf(const FileTraits& file)
{
  const auto begin = withoutMark(file.begin);
  if (isLas(begin)) return CloudFormat::Las;
  if (isPly(begin)) return CloudFormat::Ply;
  if (isPcd(begin)) return CloudFormat::Pcd;
  if (!otherKindOf(file).empty()) return {};
  if (isKittiScan(file)) return CloudFormat::Kitti;
  if (isTextOfPoints(file)) return CloudFormat::Text;
  return {};
}

std::string_view whatIs(CloudFormat format)
{
  switch (format)
  {
    case CloudFormat::Las:
      return "a point cloud of a laser scanner (.las)"sv;
    case CloudFormat::Ply:
      return "a point cloud or mesh (.ply)"sv;
    case CloudFormat::Pcd:
      return "a point cloud of PCL (.pcd)"sv;
    case CloudFormat::Text:
      return "a text, of points perhaps"sv;
    case CloudFormat::Kitti:
      return "by its name and size a scan of KITTI (.bin)"sv;
  }
  return "";
}

}  // namespace mrpt_mapconv::files
