// A conversion goes in strips of some hundred blocks; the maps of the other tests fit into one.
// Here large ones: in one go (several strips) against piece by piece (one strip each), bit for bit.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>

#include <cstring>

namespace
{
using namespace mrpt_mapconv;
using freespace::FloorFrom;

/** Terrain, walls and gaps by arithmetic on the keys, of any size. */
class ArithmeticSource : public voxel::VoxelSource
{
 public:
  ArithmeticSource(std::int32_t width, std::int32_t height) : m_width(width), m_height(height) {}
  double resolution() const override { return 0.1; }
  std::optional<voxel::KeyRect> bounds() const override
  {
    return voxel::KeyRect{0, 0, m_width - 1, m_height - 1};
  }
  void read(voxel::ColumnBlock& block) const override
  {
    block.setHeight(0, 64);
    for (std::int32_t y = 0; y < voxel::kBlockSide; ++y)
      for (std::int32_t x = 0; x < voxel::kBlockSide; ++x)
      {
        const std::uint32_t kx = static_cast<std::uint32_t>(block.key().x * voxel::kBlockSide + x);
        const std::uint32_t ky = static_cast<std::uint32_t>(block.key().y * voxel::kBlockSide + y);
        if (kx >= static_cast<std::uint32_t>(m_width) || ky >= static_cast<std::uint32_t>(m_height))
          continue;  // negative keys, too
        const std::uint32_t hash = (kx * 2654435761u ^ ky * 2246822519u) >> 16;
        if (hash % 11 == 0) continue;  // unknown
        const bool wall = hash % 7 == 0;
        const auto floor = static_cast<std::int32_t>(kx / 9 + ky / 5 + hash % 3) % 40;
        // the ground itself was not seen everywhere
        if (hash % 3 == 0) block.markCube<1>(x, y, floor, true);
        for (std::int32_t z = floor + 1; z < floor + 13; ++z) block.markCube<1>(x, y, z, wall);
      }
  }

 private:
  std::int32_t m_width, m_height;
};

void expectSame(const freespace::Layers& a, const freespace::Layers& b)
{
  ASSERT_EQ(a.frame(), b.frame());
  const auto left = a.named(), right = b.named();
  for (std::size_t i = 0; i < left.size(); ++i)
    EXPECT_EQ(0, std::memcmp(left[i].second->cells().data(), right[i].second->cells().data(),
                             left[i].second->cells().size() * sizeof(float)))
        << left[i].first;
}

void expectStripsDoNotMatter(std::int32_t width, std::int32_t height, std::int32_t window,
                             freespace::FloorFrom floorFrom)
{
  SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height) + ", window " +
               std::to_string(window) + ", floorFrom " + params::textOf(floorFrom));
  const ArithmeticSource source(width, height);
  auto params = freespace::ConversionParams::paper();
  params.slopeWindow = window;
  params.maxStep = 0.3;
  params.floorFrom = floorFrom;
  freespace::IncrementalLayers pieces(params, 2);
  constexpr std::int32_t kPiece = 320;  // 100 blocks
  for (std::int32_t y = 0; y < height; y += kPiece)
    for (std::int32_t x = 0; x < width; x += kPiece)
      pieces.update(source,
                    voxel::ColumnSet::of({source.resolution(), x, y, std::min(kPiece, width - x),
                                          std::min(kPiece, height - y)}));
  const auto whole = freespace::convert(source, params, 2);
  EXPECT_GT(freespace::statistics(whole).free, whole.frame().size() / 2);
  EXPECT_GT(freespace::statistics(whole).occupied, whole.frame().size() / 100);
  EXPECT_EQ(freespace::statistics(whole).inferred > 0, floorFrom == FloorFrom::Seen);
  expectSame(pieces.exact(source), whole);
}
}  // namespace

TEST(Strips, OfManyRowsGiveTheSameLayers)
{
  expectStripsDoNotMatter(1000, 1300, 2, FloorFrom::LowestFree);
  expectStripsDoNotMatter(1000, 1300, 2, FloorFrom::Seen);
  expectStripsDoNotMatter(1000, 1300, 40, FloorFrom::LowestFree);
}

// a row of blocks is a strip by itself here, unless the window reaches farther than one row
TEST(Strips, OfOneRowGiveTheSameLayers)
{
  expectStripsDoNotMatter(17000, 300, 2, FloorFrom::LowestFree);
  expectStripsDoNotMatter(17000, 300, 2, FloorFrom::Seen);
  expectStripsDoNotMatter(17000, 300, 100, FloorFrom::LowestFree);
}
