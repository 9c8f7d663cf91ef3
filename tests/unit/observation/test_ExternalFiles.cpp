#include <mrpt/img/CImage.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt_mapconv/observation/ExternalFiles.h>

#include "support/ScanFixtures.h"

// Range images and points that lie in files beside their log.
namespace mrpt_mapconv::observation
{
using namespace fixtures;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationPointCloud;

namespace
{
/** With a range image of 6 x 8 pixels in a file of that name, if that is not there yet. */
CObservation3DRangeScan::Ptr rangeScan(const std::string& folder, const std::string& file)
{
  auto scan = CObservation3DRangeScan::Create();
  scan->sensorLabel = "KINECT";
  scan->timestamp = mrpt::Clock::fromDouble(1e9);
  scan->hasRangeImage = true;
  scan->rangeImage.setSize(6, 8);
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 8; ++column)
      scan->rangeImage(row, column) = static_cast<std::uint16_t>(1000 + 777 * row + 31 * column);
  scan->rangeImage_convertToExternalStorage(file, folder);
  return scan;
}

CObservation3DRangeScan::Ptr pointScan(const std::string& folder, const std::string& file)
{
  auto scan = CObservation3DRangeScan::Create();
  scan->hasPoints3D = true;
  scan->resizePoints3DVectors(2);
  scan->points3D_x = {1, 2};
  scan->points3D_y = {3, 4};
  scan->points3D_z = {5, 6};
  scan->points3D_convertToExternalStorage(file, folder);
  return scan;
}

CObservationPointCloud cloud(const std::string& file,
                             CObservationPointCloud::ExternalStorageFormat format)
{
  CObservationPointCloud scan;
  scan.pointcloud = mrpt::maps::CSimplePointsMap::Create();
  scan.pointcloud->insertPoint(1, 2, 3);
  scan.setAsExternalStorage(file, format);
  return scan;
}

/** Reads the scan from each beginning of its file, none of which is whole. */
template <class Scan>
void expectEveryTruncationToThrow(const Scan& scan)
{
  const std::string path = externalFilesOf(scan).at(0), whole = readBytes(path);
  for (std::size_t n = 0; n < whole.size(); ++n)
  {
    writeBytes(path, whole.substr(0, n));
    Scan copy = scan;
    EXPECT_TRUE(contains(messageOf([&copy] { loadExternal(copy); }), path)) << n;
  }
  writeBytes(path, whole);
}

class ExternalFiles : public ::testing::Test
{
 protected:
  void SetUp() override { mrpt::img::CImage::setImagesPathBase(m_dir.path()); }

  std::vector<PosedObservation> scansIn(const std::vector<std::string>& files) const
  {
    std::vector<PosedObservation> scans;
    for (const auto& file : files) scans.push_back({rangeScan(m_dir.path(), file), {}});
    return scans;
  }

  TempDir m_dir;
};
}  // namespace

TEST_F(ExternalFiles, AreReadAsMrptReadsThem)
{
  const auto ranges = rangeScan(m_dir.path(), "r.bin"), points = pointScan(m_dir.path(), "p.bin");
  for (const auto& scan : {ranges, points})
  {
    CObservation3DRangeScan ours = *scan, theirs = *scan;
    loadExternal(ours);
    theirs.load();
    EXPECT_EQ(theirs.rangeImage, ours.rangeImage);
    EXPECT_EQ(theirs.points3D_x, ours.points3D_x);
    EXPECT_EQ(theirs.points3D_z, ours.points3D_z);
    EXPECT_EQ(1u, externalFilesOf(*scan).size());
    EXPECT_TRUE(externalFilesOf(ours).empty()) << "nothing is left to be read";
  }
}

TEST_F(ExternalFiles, MrptTakesAFileThatIsCutOffForAWholeOneButWeDoNot)
{
  expectEveryTruncationToThrow(*rangeScan(m_dir.path(), "r.bin"));
  expectEveryTruncationToThrow(*pointScan(m_dir.path(), "p.bin"));
  auto stored = cloud("c.bin", CObservationPointCloud::ExternalStorageFormat::MRPT_Serialization);
  stored.unload();
  expectEveryTruncationToThrow(stored);
}

TEST_F(ExternalFiles, ACloudOfKittiHasFourFloatsAPoint)
{
  auto scan = cloud("k.bin", CObservationPointCloud::ExternalStorageFormat::KittiBinFile);
  scan.pointcloud.reset();
  writeBytes(m_dir.file("k.bin"), std::string(32, '\0'));
  EXPECT_NO_THROW(loadExternal(scan));
  EXPECT_EQ(2u, scan.pointcloud->size());
  scan.pointcloud.reset();
  writeBytes(m_dir.file("k.bin"), std::string(33, '\0'));
  EXPECT_TRUE(contains(messageOf([&] { loadExternal(scan); }), "k.bin: is truncated"));
}

TEST_F(ExternalFiles, AFolderWithoutThemIsAnErrorWithAllThatIsNeededToFindThem)
{
  auto scans = scansIn({"r0.bin", "r1.bin"});
  std::filesystem::remove(m_dir.file("r0.bin"));
  std::filesystem::remove(m_dir.file("r1.bin"));
  const auto message =
      messageOf([&] { findExternalFiles(scans, m_dir.file("drive.rawlog"), nullptr); });
  EXPECT_EQ(0u, message.find(m_dir.file("drive.rawlog") + ": 2 of 2 scans"));
  for (const std::string words :
       {"scan 1", "'KINECT'", "at 1000000000.000 s", "no file r0.bin", "drive_Images", "Images in"})
    EXPECT_TRUE(contains(message, words)) << words << " in " << message;
}

TEST_F(ExternalFiles, ScansWithoutThemAreLeftOutWithOneWarning)
{
  auto scans = scansIn({"r0.bin", "r1.bin", "r2.bin"});
  std::filesystem::remove(m_dir.file("r1.bin"));
  std::filesystem::remove(m_dir.file("r2.bin"));
  const Warnings log;
  findExternalFiles(scans, m_dir.file("drive.rawlog"), &log);
  EXPECT_EQ(1u, scans.size());
  ASSERT_EQ(1u, log.texts.size());
  for (const char* words : {"2 of 3 scans", "scan 2", "no file r1.bin", "they are left out"})
    EXPECT_TRUE(contains(log.texts[0], words)) << words << " in " << log.texts[0];
}

TEST_F(ExternalFiles, TheFolderIsTheOneThatHasThem)
{
  std::filesystem::create_directory(m_dir.file("drive_Images"));
  std::filesystem::create_directory(m_dir.file("Images"));
  std::vector<PosedObservation> scans{{rangeScan(m_dir.file("Images"), "r0.bin"), {}}};
  findExternalFiles(scans, m_dir.file("drive.rawlog"), nullptr);
  EXPECT_EQ(1u, scans.size());
  EXPECT_EQ(m_dir.file("Images/r0.bin"), externalFilesOf(*scans[0].observation).at(0));
}

}  // namespace mrpt_mapconv::observation
