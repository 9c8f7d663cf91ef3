#pragma once

#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/octomap.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace mrpt_mapconv::test
{
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/** A small voxel map written out by hand. */
class HandMap
{
 public:
  explicit HandMap(double resolution) : m_tree(resolution), m_source(m_tree) {}

  HandMap(const HandMap&) = delete;  // the source refers to the tree
  HandMap& operator=(const HandMap&) = delete;

  octomap::OcTree& tree() { return m_tree; }
  const voxel::VoxelSource& source() const { return m_source; }

  static octomap::OcTreeKey key(int kx, int ky, int kz)
  {
    return {static_cast<octomap::key_type>(kx + 32768), static_cast<octomap::key_type>(ky + 32768),
            static_cast<octomap::key_type>(kz + 32768)};
  }

  /** Voxels [zBegin, zEnd) of column (kx, ky). */
  HandMap& free(int kx, int ky, int zBegin, int zEnd) { return set(kx, ky, zBegin, zEnd, -0.4f); }
  HandMap& occupied(int kx, int ky, int zBegin, int zEnd)
  {
    return set(kx, ky, zBegin, zEnd, 0.85f);
  }

  /** Column (kx, ky) from voxel zBegin upwards: 'f' is free, '#' occupied, '.' unknown. */
  HandMap& column(int kx, int ky, int zBegin, const std::string& upwards)
  {
    for (const char state : upwards)
    {
      if (state == 'f') free(kx, ky, zBegin, zBegin + 1);
      if (state == '#') occupied(kx, ky, zBegin, zBegin + 1);
      ++zBegin;
    }
    return *this;
  }

  /** Free columns of `height` voxels whose floors have the given z keys, north up (the first row
   * has the highest y); kNoFloor leaves a column out. The south-west cell has the key (0, 0). */
  static constexpr int kNoFloor = std::numeric_limits<int>::min();
  HandMap& floors(const std::vector<std::vector<int>>& northUp, int height = 20)
  {
    for (std::size_t row = 0; row < northUp.size(); ++row)
      for (std::size_t kx = 0; kx < northUp[row].size(); ++kx)
        if (const int floor = northUp[row][kx]; floor != kNoFloor)
          free(static_cast<int>(kx), static_cast<int>(northUp.size() - 1 - row), floor,
               floor + height);
    return *this;
  }

  freespace::Layers convert(const freespace::ConversionParams& params) const
  {
    return freespace::convert(m_source, params, 1);
  }

 private:
  HandMap& set(int kx, int ky, int zBegin, int zEnd, float logOdds)
  {
    for (int kz = zBegin; kz < zEnd; ++kz) m_tree.setNodeValue(key(kx, ky, kz), logOdds);
    return *this;
  }

  octomap::OcTree m_tree;
  voxel::OctreeSource<octomap::OcTree> m_source;
};

/** A layer's cells against numbers written north up (the first row has the highest y). */
inline void expectCells(const grid::Layer<float>& layer,
                        const std::vector<std::vector<float>>& northUp, float tolerance = 0)
{
  ASSERT_EQ(layer.frame().height, static_cast<int>(northUp.size()));
  for (int iy = 0; iy < layer.frame().height; ++iy)
  {
    const std::vector<float>& row = northUp[northUp.size() - 1 - static_cast<std::size_t>(iy)];
    ASSERT_EQ(layer.frame().width, static_cast<int>(row.size()));
    for (int ix = 0; ix < layer.frame().width; ++ix)
    {
      const float value = layer.at(ix, iy), expected = row[static_cast<std::size_t>(ix)];
      if (std::isnan(expected))
        EXPECT_TRUE(std::isnan(value)) << "cell (" << ix << ", " << iy << ") is " << value;
      else
        EXPECT_NEAR(value, expected, tolerance) << "cell (" << ix << ", " << iy << ")";
    }
  }
}

}  // namespace mrpt_mapconv::test
