#include <mrpt_mapconv/files/CloudFormat.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/files/ForeignKind.h>
#include <mrpt_mapconv/files/InputStream.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "OtherKind.h"
#include "TextBytes.h"

namespace mrpt_mapconv::files
{
namespace
{
using namespace std::string_view_literals;

/** A kind of file, and the bytes that tell it. */
struct Kind
{
  std::size_t offset;
  std::string_view magic, what, remedy;
};

// Remedies name programs that exist, with the package (of Debian, unless it says otherwise).
constexpr auto kCloud =
    "it does not say from where its points were seen: convert and terrain need --trajectory FILE "
    "and times in it, info and ground do without"sv;
constexpr auto kLaz =
    "pdal (conda-forge) makes a .las of it: pdal translate IN.laz OUT.las; so does Python's "
    "laspy[lazrs]"sv;
constexpr auto kE57 = "Python's pye57 reads its points, which are read here as text (.xyz)"sv;
constexpr auto kDamaged = "it is damaged, or of another kind than its name says"sv;
constexpr auto kRos1 = "rosbag2rawlog (mrpt-apps) makes a .rawlog of it"sv;
constexpr auto kRos2 =
    "rosbags-convert (Python package rosbags) makes a ROS 1 bag of it, and rosbag2rawlog "
    "(mrpt-apps) a .rawlog of that"sv;
constexpr auto kFlat =
    "it holds no heights, so no 3D map can be read from it; ros-map-yaml2mrpt (mrpt-apps) makes a "
    ".gridmap of a ROS map's .yaml"sv;
constexpr auto kMola = "MOLA's sm2mm made it of a .simplemap, which is read"sv;
constexpr auto kCapture =
    "rawlog-grabber (mrpt-apps) makes a .rawlog of the packets of a Velodyne"sv;
constexpr auto kMesh =
    "binvox makes a .binvox of a mesh, and binvox2bt (octomap-tools) a .bt of that"sv;
constexpr auto kPacked = "unpack it first; only gzip is unpacked here"sv;
constexpr auto kPicture =
    "image2gridmap (mrpt-apps) makes a .gridmap of a picture, but a 3D map cannot be read from it"sv;
constexpr auto kNoRemedy =
    "what is read are octomaps (.bt, .ot), .rawlog, .simplemap and serialized MRPT maps"sv;

constexpr Kind kKinds[] = {
    {0, "LASF"sv, "a packed point cloud of a laser scanner (.laz)"sv, kLaz},
    {0, "ASTM-E57"sv, "a point cloud (.e57)"sv, kE57},
    {0, "#ROSBAG V"sv, "a bag of ROS 1"sv, kRos1},
    {0, "SQLite format 3\0"sv, "an SQLite database, as ROS 2 bags (.db3) are"sv, kRos2},
    {0, "\x89MCAP0\r\n"sv, "a bag of ROS 2 (.mcap)"sv, kRos2},
    {0, "rosbag2_bagfile_information:"sv, "the description of a ROS 2 bag"sv, kRos2},
    {1, "mp2p_icp::metric_map_t"sv, "a map of MOLA (.mm)"sv, kMola},
    {0, "\xD4\xC3\xB2\xA1"sv, "a capture of network packets (.pcap)"sv, kCapture},
    {0, "\xA1\xB2\xC3\xD4"sv, "a capture of network packets (.pcap)"sv, kCapture},
    {0, "\x4D\x3C\xB2\xA1"sv, "a capture of network packets (.pcap)"sv, kCapture},
    {0, "\xA1\xB2\x3C\x4D"sv, "a capture of network packets (.pcap)"sv, kCapture},
    {0, "\x0A\x0D\x0D\x0A"sv, "a capture of network packets (.pcapng)"sv, kCapture},
    {0, "#binvox"sv, "a voxel grid (.binvox)"sv, "binvox2bt (octomap-tools) makes a .bt of it"sv},
    {0, "glTF"sv, "a mesh (.glb)"sv, kMesh},
    {0, " BDV"sv, "a voxel grid of OpenVDB (.vdb)"sv, kNoRemedy},
    {0, "\x89PNG\r\n\x1A\n"sv, "a picture (.png)"sv, kPicture},
    {0, "\xFF\xD8\xFF"sv, "a picture (.jpg)"sv, kPicture},
    {0, "GIF87a"sv, "a picture (.gif)"sv, kPicture},
    {0, "GIF89a"sv, "a picture (.gif)"sv, kPicture},
    {0, "II*\0"sv, "a GeoTIFF or other picture (.tif)"sv, kPicture},
    {0, "II+\0"sv, "a GeoTIFF or other picture (.tif)"sv, kPicture},
    {0, "MM\0*"sv, "a GeoTIFF or other picture (.tif)"sv, kPicture},
    {0, "PK\x03\x04"sv, "a zip archive"sv, kPacked},
    {0, "\x1F\x8B\x08"sv, "gzipped twice"sv, "unpack it once (gzip -d)"sv},
    {4, "1AY&SY"sv, "packed by bzip2"sv, kPacked},
    {0, "\xFD\x37zXZ\0"sv, "packed by xz"sv, kPacked},
    {0, "\x28\xB5\x2F\xFD"sv, "packed by zstd"sv, kPacked},
    {0, "\x04\x22\x4D\x18"sv, "packed by lz4"sv, kPacked},
    {0, "7z\xBC\xAF\x27\x1C"sv, "a 7z archive"sv, kPacked},
    {257, "ustar"sv, "a tar archive"sv, kPacked},
    {0, "\x89HDF\r\n\x1A\n"sv, "a file of HDF5"sv, kNoRemedy},
    {0, "\x93NUMPY"sv, "an array of NumPy (.npy)"sv, kNoRemedy},
    {0, "%PDF-"sv, "a PDF"sv, kNoRemedy},
    {0,
     "\x7F"
     "ELF"sv,
     "a program"sv, kNoRemedy},
    {0, "<!DOCTYPE"sv, "a web page"sv, "download the file itself"sv},
    {0, "<!doctype"sv, "a web page"sv, "download the file itself"sv},
    {0, "<html"sv, "a web page"sv, "download the file itself"sv},
    {0, "<HTML"sv, "a web page"sv, "download the file itself"sv},
    {0, "version https://git-lfs"sv, "a placeholder of Git LFS"sv, "git lfs pull gets the file"sv},
};

/** The same of a file that does not begin as it should, by the ending of its name. */
struct Name
{
  std::string_view ending, what, remedy;
};

const Name kNames[] = {
    {".pcd"sv, whatIs(CloudFormat::Pcd), kDamaged},
    {".ply"sv, whatIs(CloudFormat::Ply), kDamaged},
    {".las"sv, whatIs(CloudFormat::Las), kDamaged},
    {".laz"sv, "a packed point cloud of a laser scanner (.laz)"sv, kLaz},
    {".e57"sv, "a point cloud (.e57)"sv, kE57},
    {".bag"sv, "a bag of ROS 1 (.bag)"sv, kRos1},
    {".db3"sv, "a bag of ROS 2 (.db3)"sv, kRos2},
    {".mcap"sv, "a bag of ROS 2 (.mcap)"sv, kRos2},
    {".mm"sv, "a map of MOLA (.mm)"sv, kMola},
    {".pcap"sv, "a capture of network packets (.pcap)"sv, kCapture},
    {".stl"sv, "a mesh (.stl)"sv, kMesh},
    {".obj"sv, "a mesh (.obj)"sv, kMesh},
};

const Kind* kindByMagic(std::string_view begin)
{
  const auto fits = [begin](const Kind& kind)
  {
    return begin.size() >= kind.offset &&
           begin.substr(kind.offset, kind.magic.size()) == kind.magic;
  };
  const auto* kind = std::find_if(std::begin(kKinds), std::end(kKinds), fits);
  return kind == std::end(kKinds) ? nullptr : kind;
}

bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/** Netpbm: P1 to P6 and a blank. */
bool isNetpbm(std::string_view begin)
{
  return begin.size() > 2 && begin[0] == 'P' && begin[1] >= '1' && begin[1] <= '6' &&
         isSpace(begin[2]);
}

/** Windows' bitmaps: "BM", the file's size, and four bytes that are zero. */
bool isBitmap(std::string_view begin)
{
  return begin.substr(0, 2) == "BM" && begin.size() > 10 && begin.substr(6, 4) == "\0\0\0\0"sv;
}

/** Those that are text; the others have nothing in common. */
bool isStl(std::string_view begin)
{
  return begin.substr(0, 6) == "solid " && begin.find("facet") != std::string_view::npos;
}

std::string sentence(std::string_view what, std::string_view remedy)
{
  return std::string("is ").append(what).append("; ").append(remedy);
}

/** For files whose first bytes say nothing. */
std::string kindByName(const FileTraits& file)
{
  const std::string ending = endingOf(file.name);
  if (ending == ".yaml" || ending == ".yml") return sentence("a YAML file", kFlat);
  for (const Name& name : kNames)
    if (name.ending == ending)
      return sentence("by its name " + std::string(name.what) + ", but does not begin as one",
                      name.remedy);
  return "";
}
}  // namespace

bool beginsAsObject(std::string_view bytes)
{
  if (bytes.empty()) return false;
  const unsigned char first = static_cast<unsigned char>(bytes.front());
  const bool isOld = bytes.size() > 4 && first > 0 && bytes.substr(1, 3) == "\0\0\0"sv;
  if ((first & 0x80U) == 0 && !isOld) return false;
  const auto name = isOld ? bytes.substr(4, first) : bytes.substr(1, first & 0x7FU);
  const auto isOfName = [](unsigned char c) { return c > ' ' && c < 0x7F; };
  return (name.empty() || std::isalpha(static_cast<unsigned char>(name.front())) != 0) &&
         std::all_of(name.begin(), name.end(), isOfName);
}

std::string otherKindOf(const FileTraits& file)
{
  const auto begin = withoutMark(file.begin);
  if (beginsWith(begin, "LASF") && !isPackedLas(begin)) return "";
  if (const Kind* kind = kindByMagic(begin)) return sentence(kind->what, kind->remedy);
  if (beginsAsObject(begin)) return "";
  if (isStl(begin)) return sentence("a mesh (.stl)", kMesh);
  if (isBitmap(begin)) return sentence("a picture (.bmp)", kPicture);
  if (isNetpbm(begin)) return sentence("a picture, as that of a ROS map is (.pgm)", kFlat);
  if (hasLine(begin, "image:") && hasLine(begin, "resolution:"))
    return sentence("the .yaml of a ROS map", kFlat);
  return kindByName(file);
}

std::string foreignKindOf(const FileTraits& file)
{
  if (const auto format = cloudFormatOf(file)) return sentence(whatIs(*format), kCloud);
  return otherKindOf(file);
}

void refuseForeignKinds(InputStream& stream)
{
  const auto kind = foreignKindOf({stream.name(), stream.preview(), stream.fileSize()});
  if (!kind.empty()) throw std::runtime_error(stream.name() + ": " + kind);
}

}  // namespace mrpt_mapconv::files
