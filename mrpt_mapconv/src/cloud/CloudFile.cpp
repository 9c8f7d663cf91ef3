#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/files/AtomicFile.h>
#include <mrpt_mapconv/files/CloudFormat.h>
#include <mrpt_mapconv/params/Text.h>

#include <filesystem>
#include <stdexcept>

#include "BlockInput.h"
#include "KittiFile.h"
#include "LasFile.h"
#include "PcdFile.h"
#include "PlyFile.h"
#include "TextFile.h"

namespace mrpt_mapconv::cloud
{
namespace
{
using files::CloudFormat;

std::optional<CloudFormat> formatOf(files::InputStream& stream)
{
  return files::cloudFormatOf({stream.name(), stream.preview(), stream.fileSize()});
}

/** Says what a file is that holds no cloud. */
[[noreturn]] void refuse(files::InputStream& stream)
{
  files::refuseForeignKinds(stream);
  throw std::runtime_error(stream.name() +
                           ": is no file of points that is read here: .las, .ply, .pcd, text "
                           "(.xyz, .txt, .csv) or KITTI's .bin (of 16 bytes a point)");
}

using Writer = void (*)(const std::string& path, const PointCloud& cloud);

/** By the name's ending; null for one that is not known. */
Writer findWriter(const std::string& path)
{
  const std::string ending = params::lowerCase(std::filesystem::path(path).extension().string());
  if (ending == ".las") return &writeLas;
  if (ending == ".ply") return &writePly;
  if (ending == ".pcd") return &writePcd;
  if (ending == ".bin") return &writeKitti;
  if (ending == ".csv" || ending == ".xyz" || ending == ".txt") return &writeText;
  return nullptr;
}

constexpr const char* kWithClasses = ".las, .ply, .pcd, .xyz, .txt";

Writer writerFor(const std::string& path)
{
  if (const Writer write = findWriter(path)) return write;
  throw std::runtime_error("cannot write '" + path + "': a cloud of points is written as " +
                           kWithClasses + ", .csv or .bin (KITTI)");
}
}  // namespace

bool isCloud(files::InputStream& stream) { return formatOf(stream).has_value(); }

PointCloud readCloud(files::InputStream& stream, const CloudReading& reading)
{
  const auto format = formatOf(stream);
  if (!format) refuse(stream);
  BlockInput input(stream);
  switch (*format)
  {
    case CloudFormat::Las:
      return readLas(input, reading);
    case CloudFormat::Ply:
      return readPly(input, reading);
    case CloudFormat::Pcd:
      return readPcd(input, reading);
    case CloudFormat::Text:
      return readText(input, reading);
    case CloudFormat::Kitti:
      return readKitti(input, reading);
  }
  refuse(stream);
}

PointCloud readCloudFile(const std::string& path, const CloudReading& reading)
{
  files::InputStream stream(path);
  return readCloud(stream, reading);
}

void requireNameForClasses(const std::string& path)
{
  const Writer write = findWriter(path);
  if (write != nullptr && write != &writeKitti) return;
  throw std::runtime_error("cannot write '" + path +
                           "': " + (write != nullptr ? "KITTI's .bin has no classes; " : "") +
                           "points with classes are written as " + kWithClasses + " or .csv");
}

void writeCloudFile(const std::string& path, const PointCloud& cloud)
{
  const Writer write = writerFor(path);
  files::AtomicFile file(path);
  write(file.stagingPath(), cloud);
  file.commit();
}

}  // namespace mrpt_mapconv::cloud
