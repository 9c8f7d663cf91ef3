#include <mrpt/img/CImage.h>
#include <mrpt/io/lazy_load_path.h>
#include <mrpt_mapconv/files/ForeignKind.h>
#include <mrpt_mapconv/files/InputStream.h>
#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/observation/ExternalFiles.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>

namespace mrpt_mapconv::observation
{
namespace fs = std::filesystem;
using mrpt::obs::CObservation;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationPointCloud;

namespace
{
bool hasExternalPoints(const CObservation3DRangeScan& scan)
{
  return scan.hasPoints3D && scan.points3D_isExternallyStored() && scan.points3D_x.empty();
}

bool hasExternalRanges(const CObservation3DRangeScan& scan)
{
  return scan.hasRangeImage && scan.rangeImage_isExternallyStored() && scan.rangeImage.size() == 0;
}

bool isText(const std::string& path)
{
  return params::lowerCase(fs::path(path).extension().string()) == ".txt";
}

/** Numbers of a file, which must all be there. */
class NumberFile
{
 public:
  explicit NumberFile(const std::string& path) : m_stream(path) {}

  std::uint32_t count()
  {
    std::uint32_t value = 0;
    read(&value, sizeof(value));
    return value;
  }

  template <class Number>
  void read(Number* to, std::size_t bytes)
  {
    const std::size_t got = m_stream.read(to, bytes);
    if (got == bytes) return;
    const std::string cause = m_stream.error();
    throw std::runtime_error(m_stream.name() + ": is truncated" +
                             (cause.empty() ? std::string() : " or damaged: " + cause));
  }

  /** \exception std::runtime_error unless that much can be in one scan */
  void checkCount(std::uint64_t numbers) const
  {
    constexpr std::uint64_t kMost = 1U << 28U;
    if (numbers > kMost)
      throw std::runtime_error(m_stream.name() + ": is damaged, or not of this format: it claims " +
                               std::to_string(numbers) + " numbers");
  }

  /** Reads what follows the last number, where damage of what came before shows. */
  void finish()
  {
    constexpr std::size_t kPiece = std::size_t(1) << 16U;
    while (!m_stream.readUpTo(kPiece).empty()) continue;
  }

 private:
  files::InputStream m_stream;
};

void readRanges(const std::string& path, CObservation3DRangeScan& scan)
{
  NumberFile file(path);
  const std::uint32_t rows = file.count(), columns = file.count();
  file.checkCount(std::uint64_t(rows) * columns);
  scan.rangeImage.setSize(static_cast<int>(rows), static_cast<int>(columns));
  if (scan.rangeImage.size() > 0)
    file.read(scan.rangeImage.data(), sizeof(std::uint16_t) * rows * columns);
  file.finish();
}

void readPoints(const std::string& path, CObservation3DRangeScan& scan)
{
  NumberFile file(path);
  for (auto* axis : {&scan.points3D_x, &scan.points3D_y, &scan.points3D_z})
  {
    const std::uint32_t count = file.count();
    file.checkCount(count);
    axis->resize(count);
    file.read(axis->data(), sizeof(float) * count);
  }
  file.finish();
}

void requireFile(const std::string& path)
{
  if (!fs::exists(path)) throw std::runtime_error(path + ": no such file");
}

/** Where MRPT looks for a log's external files. */
std::vector<fs::path> foldersBeside(const std::string& log)
{
  const fs::path file = fs::absolute(log);
  const std::string name = file.stem().string();
  std::vector<fs::path> folders;
  for (const auto& folder :
       {name + "_Images", name + "_images", name + "_IMAGES", std::string("Images")})
    folders.push_back(file.parent_path() / folder);
  return folders;
}

bool hasAllFiles(const CObservation& obs)
{
  const auto files = externalFilesOf(obs);
  return std::all_of(files.begin(), files.end(), [](const auto& file) { return fs::exists(file); });
}

/** Sets MRPT's lazy-load directory. CRawlog::detectImagesDirectory() of MRPT 2.5 does nearly this,
 * but forgets the slash behind the directory. */
void chooseFolder(const std::vector<fs::path>& folders, const CObservation* example)
{
  std::optional<fs::path> first;
  for (const auto& folder : folders)
  {
    if (!fs::is_directory(folder)) continue;
    if (!first) first = folder;
    mrpt::img::CImage::setImagesPathBase(folder.string());
    if (!example || hasAllFiles(*example)) return;
  }
  if (first) mrpt::img::CImage::setImagesPathBase(first->string());
}

/** Which scan lacks which file, and where it was looked for. */
std::string complaintAbout(const CObservation& obs, std::size_t number,
                           const std::vector<fs::path>& folders)
{
  const auto files = externalFilesOf(obs);
  const fs::path missing =
      *std::find_if(files.begin(), files.end(), [](const auto& file) { return !fs::exists(file); });
  std::string tried;
  for (const auto& folder : folders)
    tried += (tried.empty() ? "" : ", ") + folder.filename().string();
  tried += " in " + folders.front().parent_path().string();
  const std::string time = obs.timestamp == INVALID_TIMESTAMP
                               ? ""
                               : mrpt::format(" at %.3f s", mrpt::Clock::toDouble(obs.timestamp));
  return "scan " + std::to_string(number) + " (" + nameOf(obs) + time + ") has no file " +
         missing.filename().string() + "; folders tried: " + tried + ", and " +
         missing.parent_path().string();
}
}  // namespace

std::vector<std::string> externalFilesOf(const CObservation& obs)
{
  std::vector<std::string> files;
  if (const auto* scan = dynamic_cast<const CObservation3DRangeScan*>(&obs))
  {
    if (hasExternalPoints(*scan))
      files.push_back(scan->points3D_getExternalStorageFileAbsolutePath());
    if (hasExternalRanges(*scan))
      files.push_back(scan->rangeImage_getExternalStorageFileAbsolutePath(""));
  }
  if (const auto* scan = dynamic_cast<const CObservationPointCloud*>(&obs))
    if (!scan->pointcloud && scan->isExternallyStored())
      files.push_back(mrpt::io::lazy_load_absolute_path(scan->getExternalStorageFile()));
  return files;
}

void loadExternal(CObservation3DRangeScan& scan)
{
  bool texts = false;
  const auto load = [&](const std::string& path, const auto& read)
  {
    requireFile(path);
    if (isText(path))
      texts = true;
    else
      read(path, scan);
  };
  if (hasExternalPoints(scan)) load(scan.points3D_getExternalStorageFileAbsolutePath(), readPoints);
  if (hasExternalRanges(scan))
    load(scan.rangeImage_getExternalStorageFileAbsolutePath(""), readRanges);
  if (texts) scan.load();
}

void loadExternal(const CObservationPointCloud& scan)
{
  for (const std::string& path : externalFilesOf(scan))
  {
    requireFile(path);
    const std::string kind = params::lowerCase(fs::path(path).extension().string());
    constexpr std::uintmax_t kPoint = 4 * sizeof(float);  // of KITTI
    const bool isObject = files::beginsAsObject(files::InputStream(path).preview());
    if (isObject)
    {
      files::ObjectFile file(path);
      while (file.next()) continue;
    }
    else if (kind == ".bin" && fs::file_size(path) % kPoint != 0)
      throw std::runtime_error(path + ": is truncated: a point has 16 bytes");
    scan.load();
  }
}

void findExternalFiles(std::vector<PosedObservation>& scans, const std::string& path,
                       const mrpt::system::COutputLogger* log)
{
  const auto isStored = [](const PosedObservation& scan)
  { return !externalFilesOf(*scan.observation).empty(); };
  const auto isMissing = [](const PosedObservation& scan)
  { return !hasAllFiles(*scan.observation); };

  const auto example = std::find_if(scans.begin(), scans.end(), isStored);
  const auto folders = foldersBeside(path);
  chooseFolder(folders, example == scans.end() ? nullptr : example->observation.get());
  const auto stored = std::count_if(scans.begin(), scans.end(), isStored);
  const auto missing = std::count_if(scans.begin(), scans.end(), isMissing);
  if (missing == 0) return;

  const auto first = std::find_if(scans.begin(), scans.end(), isMissing);
  const std::string what = complaintAbout(
      *first->observation, static_cast<std::size_t>(first - scans.begin()) + 1, folders);
  const std::string which = std::to_string(missing) + " of " + std::to_string(stored) +
                            " scans that are stored outside the log cannot be found: ";
  if (missing == stored)
    throw std::runtime_error(path + ": " + which + what +
                             "; copy the log's folder of images along");
  if (log) log->logStr(mrpt::system::LVL_WARN, path + ": " + which + what + "; they are left out");
  scans.erase(std::remove_if(scans.begin(), scans.end(), isMissing), scans.end());
}

}  // namespace mrpt_mapconv::observation
