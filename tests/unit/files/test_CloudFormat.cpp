#include <gtest/gtest.h>
#include <mrpt_mapconv/files/CloudFormat.h>

using namespace mrpt_mapconv::files;
using namespace std::string_literals;

TEST(CloudFormat, FirstBytesSayMoreThanNames)
{
  const std::string las = "LASF" + std::string(100, '\0') + "\3";
  EXPECT_EQ(CloudFormat::Las, cloudFormatOf({"a.txt", las}));
  EXPECT_EQ(CloudFormat::Ply, cloudFormatOf({"a.pcd", "ply\nformat"}));
  EXPECT_EQ(CloudFormat::Ply, cloudFormatOf({"a", "ply\r\nformat"}));
  EXPECT_EQ(CloudFormat::Pcd, cloudFormatOf({"a.bt", "# .PCD v0.7"}));
  EXPECT_EQ(CloudFormat::Pcd, cloudFormatOf({"a", "# mine\nVERSION .7\nFIELDS x y z\n"}));
}

TEST(CloudFormat, NamesDecideWhereFirstBytesSayNothing)
{
  for (const char* name : {"a.xyz", "a.TXT", "a.csv", "a.asc", "a.pts", "a.csv.gz"})
    EXPECT_EQ(CloudFormat::Text, cloudFormatOf({name, "1 2 3\n"})) << name;
  EXPECT_EQ(CloudFormat::Kitti, cloudFormatOf({"a.bin", "\x9e\xef\xd7\x41\0\0\0\0"s, 1600}));
}

TEST(CloudFormat, OtherFilesHaveNone)
{
  const std::string laz = "LASF" + std::string(100, '\0') + "\x83";
  const FileTraits others[] = {
      {"a.laz", laz},        {"a.pcd", "1 2 3\n"},
      {"a.las", "nothing"},  {"a.txt", "\x89PNG\r\n\x1a\n"},
      {"a.txt", "1 2\0 3"s}, {"a.bin", "\1\2\3\4", 1601},
      {"a.bin", "\1\2\3\4"}, {"a.bin", "\x94mrpt::maps::COctoMap..\1", 1600},
      {"a", "1 2 3\n"},      {"a.bt", "# Octomap OcTree binary file\n"}};
  for (const auto& file : others) EXPECT_FALSE(cloudFormatOf(file)) << file.name;
}
