// Small files of points to begin with, a folder a format: make_seeds DIR
#include <liblzf/lzf.h>
#include <mrpt_mapconv/cloud/CloudFile.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

using namespace mrpt_mapconv;

namespace
{
cloud::PointCloud points(bool withTimes)
{
  cloud::PointCloud cloud;
  cloud.x = {1, 2.5, -3};
  cloud.y = {4, 5, 6};
  cloud.z = {7, 8.25, 9};
  if (withTimes) cloud.time = {0.5, 1, 1.5};
  cloud.intensity = {1, 2, 3};
  cloud.classification = {1, 2, 7};
  cloud.coordinateSystem = withTimes ? "GEOGCS[\"WGS 84\"]" : "EPSG:32632";
  return cloud;
}

template <class Number>
std::string bytesOf(Number number)
{
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::string compressedPcd()
{
  const std::string plain(3 * 3 * sizeof(float), '\1');
  std::string packed(100, '\0');
  packed.resize(
      lzf_compress(plain.data(), static_cast<unsigned>(plain.size()), packed.data(), 100));
  return "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 1\n"
         "POINTS 3\nDATA binary_compressed\n" +
         bytesOf(static_cast<std::uint32_t>(packed.size())) +
         bytesOf(static_cast<std::uint32_t>(plain.size())) + packed;
}
}  // namespace

int main(int argc, char** argv)
{
  if (argc != 2) return 2;
  const std::string dir = argv[1];
  const auto in = [&](const std::string& format, const std::string& name)
  {
    std::filesystem::create_directories(dir + "/" + format);
    return dir + "/" + format + "/" + name;
  };
  for (const std::string format : {"las", "ply", "pcd", "csv", "bin"})
    for (const bool withTimes : {false, true})
      cloud::writeCloudFile(in(format, (withTimes ? "b." : "a.") + format), points(withTimes));
  std::ofstream(in("pcd", "ascii")) << "VERSION .7\nFIELDS x y z _\nSIZE 4 4 4 1\nTYPE F F F U\n"
                                       "COUNT 1 1 1 2\nPOINTS 1\nDATA ascii\n1 2 3 0 0\n";
  std::ofstream(in("pcd", "packed"), std::ios::binary) << compressedPcd();
  std::ofstream(in("ply", "ascii"))
      << "ply\nformat ascii 1.0\nelement camera 1\nproperty list uchar int a\nelement vertex 1\n"
         "property float x\nproperty float y\nproperty list uchar int l\nproperty float z\n"
         "end_header\n2 1 1\n1 2 1 5 3\n";
  std::ofstream(in("ply", "big"), std::ios::binary)
      << "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\n"
         "property list uchar short l\nproperty uchar z\nend_header\n\1\2\1zz\3";
  std::ofstream(in("csv", "names")) << "2\n# x;y;z;time\n1;2;3;4\n5;nan;6;7\n";
  return 0;
}
