// Any bytes as a file of points, with libFuzzer: each ends as a cloud or as an error of one line.
// run.sh builds it once for each format, with the file's name as MAPCONV_FUZZ_NAME.
#include <mrpt_mapconv/cloud/CloudFields.h>
#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/cloud/LasClasses.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

using namespace mrpt_mapconv;

namespace
{
void require(bool ok, const char* what)
{
  if (ok) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

void requireOneLine(const std::runtime_error& error)
{
  require(std::string(error.what()).find('\n') == std::string::npos, "an error is one line");
}

/** A folder in memory for this process. */
std::string folder()
{
  static const std::string path = "/dev/shm/mapconv-fuzz-" + std::to_string(::getpid()) + "/";
  static const bool made = std::filesystem::create_directories(path);
  static const int removed = std::atexit([] { std::filesystem::remove_all(folder()); });
  (void)made;
  (void)removed;
  return path;
}

void check(const cloud::PointCloud& read)
{
  require(!read.empty(), "an empty cloud is an error");
  cloud::visitFields(
      read,
      [&](cloud::Field field, const char*, const auto& values)
      {
        require((field > cloud::Field::Z && values.empty()) || values.size() == read.size(),
                "each point has a value of each field");
      });
  for (std::size_t i = 0; i < read.size(); ++i)
    require(std::isfinite(read.x[i]) && std::isfinite(read.y[i]) && std::isfinite(read.z[i]),
            "coordinates are finite");
}

/** Not all clouds fit into each format; what is written has all points. */
void writeAndRead(const std::string& path, const cloud::PointCloud& cloud)
{
  try
  {
    cloud::writeCloudFile(path, cloud);
  }
  catch (const std::runtime_error& e)
  {
    requireOneLine(e);
    return;
  }
  require(cloud::readCloudFile(path).size() == cloud.size(), "what is written is read");
}

void readAndWrite(const std::string& path)
{
  const cloud::PointCloud read = cloud::readCloudFile(path);
  check(read);
  for (const char* name : {"out.las", "out.ply", "out.pcd", "out.csv", "out.bin"})
    writeAndRead(folder() + name, read);
  if (read.format.compare(0, 3, "LAS") == 0)
    cloud::copyLasWithClasses(path, folder() + "out.las",
                              std::vector<std::uint8_t>(read.size(), 2));
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string path = folder() + MAPCONV_FUZZ_NAME;
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try
  {
    readAndWrite(path);
  }
  catch (const std::runtime_error& e)
  {
    requireOneLine(e);
  }
  return 0;
}
