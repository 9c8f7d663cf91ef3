#include <gtest/gtest.h>
#include <mrpt_mapconv/files/ForeignKind.h>

#include <vector>

#include "support/TempDir.h"

using namespace mrpt_mapconv::files;
using namespace mrpt_mapconv::testing;
using namespace std::string_literals;

namespace
{
struct Example
{
  std::string name, begin, words;  //!< that the message must hold
  std::uintmax_t size = 1000;
};

const std::vector<Example> kExamples = {
    {"x", "# .PCD v0.7 - Point Cloud Data file format\n", "a point cloud of PCL (.pcd)"},
    {"x", "\xEF\xBB\xBF# .PCD v0.7\r\n", "a point cloud of PCL (.pcd)"},
    {"x", "VERSION .7\r\nFIELDS x y z\r\n", "a point cloud of PCL (.pcd)"},
    {"x", "# from the attic\nVERSION 0.6\nCOLUMNS x y z\n", "a point cloud of PCL (.pcd)"},
    {"scan.pcd", "1 2 3\n", "by its name a point cloud of PCL (.pcd), but does not begin"},
    {"drive.BAG", "\1\2", "rosbag2rawlog"},
    {"a.laz", "\1\2", "pdal translate"},
    {"a.las.gz", "\1\2", "a point cloud of a laser scanner (.las)"},
    {"a.ply", "\1\2", "(.ply)"},
    {"a.e57", "\1\2", "(.e57)"},
    {"a.mcap", "\1\2", "rosbags-convert"},
    {"a.db3", "\1\2", "rosbags-convert"},
    {"map.bt.gz.gz", "\x1f\x8b\x08\x00"s, "gzipped twice; unpack it once"},
    {"x", "BM\x36\x10\0\0\0\0\0\0\x36\0"s, "(.bmp)"},
    {"x", "solid cube\n facet normal 0 0 1\n", "(.stl)"},
    {"x", "BZh91AY&SY\1", "bzip2"},
    {"x", "ply\nformat ascii 1.0\n", "(.ply)"},
    {"x", "ply\r\nformat", "(.ply)"},
    {"x", "LASF\0\0\0\0"s, "a point cloud of a laser scanner (.las); it does not say from where"},
    {"x", "LASF" + std::string(100, '\0') + "\x83",
     "a packed point cloud of a laser scanner (.laz)"},
    {"x", "ASTM-E57\1\0\0\0"s, "pye57"},
    {"x", "#ROSBAG V2.0\n", "rosbag2rawlog (mrpt-apps)"},
    {"x", "SQLite format 3\0\x10"s, "rosbags-convert"},
    {"x", "\x89MCAP0\r\n\1", "ROS 2 (.mcap)"},
    {"x", "P5\n# by a map server\n10 10\n255\n", "ros-map-yaml2mrpt"},
    {"x", "P2 10 10", "(.pgm)"},
    {"x", "image: a.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n", "the .yaml of a ROS map"},
    {"x", "# a map\nmode: trinary\nresolution: 0.05\nimage: a.pgm\n", "the .yaml of a ROS map"},
    {"map.yaml", "some: thing\n", "a YAML file"},
    {"x", "\x96mp2p_icp::metric_map_t\1", "a map of MOLA (.mm)"},
    {"x.mm", "\1\2\3\4", "a map of MOLA (.mm)"},
    {"000001.bin", "\x9e\xef\xd7\x41\0\0\0\0"s, "a scan of KITTI (.bin)", 1600},
    {"points.XYZ", "1 2 3\n", "a text, of points perhaps"},
    {"x", "\x89PNG\r\n\x1a\n", "(.png)"},
    {"x", "\xff\xd8\xff\xe0", "(.jpg)"},
    {"x", "II*\0\x08"s, "(.tif)"},
    {"x", "\xd4\xc3\xb2\xa1\2", "rawlog-grabber"},
    {"x", "PK\3\4", "zip archive"},
    {"x", "\x89HDF\r\n\x1a\n", "HDF5"},
    {"x", std::string(257, 'x') + "ustar", "tar archive"},
    {"x", "version https://git-lfs.github.com/spec/v1\n", "git lfs pull"},
    {"x", "#binvox 1\n", "binvox2bt"},
};
}  // namespace

TEST(ForeignKind, IsRecognisedByItsFirstBytesOrByNameAndSize)
{
  for (const auto& [name, begin, words, size] : kExamples)
  {
    const auto said = foreignKindOf({name, begin, size});
    EXPECT_TRUE(contains(said, words)) << words << " in '" << said << "'";
    EXPECT_EQ(0U, said.find("is ")) << said;
    EXPECT_TRUE(contains(said, "; ")) << said;
  }
}

TEST(ForeignKind, FilesThatAreReadAreNone)
{
  // the last two: MRPT's objects under names of others
  const std::vector<Example> ours = {{"a.bt", "# Octomap OcTree binary file\n", ""},
                                     {"a.txt.rawlog", "\x94mrpt::obs::CSensoryFrame", ""},
                                     {"a.map", "\x16\0\0\0CSensFrameProbSequence"s, ""},
                                     {"map.bin", "\x94mrpt::maps::COctoMap..\1", "", 1600},
                                     {"map.mm", "\x94mrpt::maps::COctoMap..\1", ""}};
  for (const auto& [name, begin, words, size] : ours)
    EXPECT_EQ("", foreignKindOf({name, begin, size})) << name;
}

TEST(ForeignKind, ATextIsNoneForAFewLettersOfIts)
{
  for (const char* text : {"BMW drove here", "solid ground", "BZhang's map", "GIF8 is it not"})
    EXPECT_EQ("", foreignKindOf({"x", text})) << text;
}

TEST(ForeignKind, AScanOfKittiHasFourFloatsAPoint)
{
  EXPECT_EQ("", foreignKindOf({"a.bin", "\1\2\3\4", 1601}));
  EXPECT_EQ("", foreignKindOf({"a.bin", "\1\2\3\4", {}}));  // a pipe
}

TEST(ForeignKind, MrptsObjectsBeginWithTheNameOfTheirClass)
{
  EXPECT_TRUE(beginsAsObject("\x94mrpt::maps::COctoMap..\1"));
  EXPECT_TRUE(beginsAsObject("\x94mr"));  // cut off
  EXPECT_TRUE(beginsAsObject("\x16\0\0\0CSensFrameProbSequence"s));
  for (const auto& other : {""s, "text"s, "\xff\xfe\1\2"s, "\x94 blank"s, "\0\0\0\0abc"s})
    EXPECT_FALSE(beginsAsObject(other)) << other;
}
