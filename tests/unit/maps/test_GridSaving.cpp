#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/maps/GridSaving.h>

#include <filesystem>

#include "support/ScanFixtures.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::maps::COccupancyGridMap2D;

TEST(GridSaving, StagesTheGridAndMore)
{
  const TempDir dir;
  const COccupancyGridMap2D grid(-1, 1, -1, 1, 0.1f);
  maps::saveStaged(grid, dir.file("new/m"),
                   [](files::OutputDir& out, const std::string& name)
                   { files::writeFile(out.path(name + "_note.txt"), "here"); });
  EXPECT_TRUE(std::filesystem::exists(dir.file("new/m.png")));
  EXPECT_TRUE(std::filesystem::exists(dir.file("new/m_limits.txt")));
  EXPECT_EQ(readBytes(dir.file("new/m_note.txt")), "here");
}

TEST(GridSaving, NothingAppearsIfOneFileCannotBeWritten)
{
  const TempDir dir;
  const COccupancyGridMap2D grid(-1, 1, -1, 1, 0.1f);
  EXPECT_THROW(maps::saveStaged(grid, dir.file("new/m"),
                                [](files::OutputDir&, const std::string&)
                                { throw std::runtime_error("no"); }),
               std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(dir.file("new")));
}

TEST(GridSaving, AllOptionsComeBack)
{
  COccupancyGridMap2D grid, read;
  grid.insertionOptions.maxDistanceInsertion = 7;
  grid.insertionOptions.maxFreenessUpdateCertainty = 0.61f;
  grid.insertionOptions.maxFreenessInvalidRanges = 0.57f;
  grid.likelihoodOptions.LF_stdHit = 0.4f;
  grid.likelihoodOptions.LF_useSquareDist = true;
  grid.genericMapParams.enableSaveAs3DObject = false;
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  maps::writeGridOptions(archive, grid);
  stream.Seek(0);
  maps::readGridOptions(archive, read);
  EXPECT_EQ(read.insertionOptions.maxDistanceInsertion, 7);
  EXPECT_EQ(read.insertionOptions.maxFreenessUpdateCertainty, 0.61f);
  EXPECT_EQ(read.insertionOptions.maxFreenessInvalidRanges, 0.57f);
  EXPECT_EQ(read.likelihoodOptions.LF_stdHit, 0.4f);
  EXPECT_TRUE(read.likelihoodOptions.LF_useSquareDist);
  EXPECT_FALSE(read.genericMapParams.enableSaveAs3DObject);
}

TEST(GridSaving, ALayerComesBackWithItsFrame)
{
  grid::Layer<float> layer({0.25, -3, 4, 2, 3}, 1), read;
  layer.at(1, 2) = -5;
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  maps::writeLayer(archive, layer);
  stream.Seek(0);
  maps::readLayer(archive, read);
  EXPECT_EQ(read.frame(), layer.frame());
  EXPECT_EQ(read.cells(), layer.cells());
}

TEST(GridSaving, ALayerWithTooFewCellsIsRefused)
{
  grid::Layer<float> layer({0.25, 0, 0, 2, 3}, 1), read;
  layer.cells().pop_back();
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  maps::writeLayer(archive, layer);
  stream.Seek(0);
  EXPECT_THROW(maps::readLayer(archive, read), std::runtime_error);
  EXPECT_TRUE(read.cells().empty());
}
