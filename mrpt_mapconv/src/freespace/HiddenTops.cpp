#include <mrpt_mapconv/freespace/HiddenTops.h>

#include <algorithm>

namespace mrpt_mapconv::freespace
{
namespace
{
bool isBefore(const HiddenTop& a, const HiddenTop& b) { return a.column < b.column; }
}  // namespace

std::optional<std::int32_t> HiddenTops::at(voxel::BlockKey block, std::int32_t column) const
{
  const auto tops = m_blocks.find(block);
  if (tops == m_blocks.end()) return std::nullopt;
  const auto& [key, all] = *tops;
  const auto top = std::lower_bound(all.begin(), all.end(), HiddenTop{column, 0}, isBefore);
  return top != all.end() && top->column == column ? std::optional(top->top) : std::nullopt;
}

std::optional<std::int32_t> HiddenTops::at(std::int32_t kx, std::int32_t ky) const
{
  // blocks begin at multiples of their side, also below 0
  constexpr std::int32_t side = voxel::kBlockSide, last = side - 1;
  return at({(kx - (kx & last)) / side, (ky - (ky & last)) / side},
            side * (ky & last) + (kx & last));
}

void HiddenTops::replace(voxel::BlockKey block, const voxel::ColumnMask& columns,
                         const std::vector<HiddenTop>& found)
{
  const auto before = m_blocks.find(block);
  if (before == m_blocks.end() && found.empty()) return;
  Tops kept;
  if (before != m_blocks.end())
    for (const HiddenTop& top : before->second)
    {
      const std::uint32_t row = columns[static_cast<std::size_t>(top.column / voxel::kBlockSide)];
      if (!(row >> (top.column % voxel::kBlockSide) & 1U)) kept.push_back(top);
    }
  Tops all(kept.size() + found.size());
  std::merge(kept.begin(), kept.end(), found.begin(), found.end(), all.begin(), isBefore);
  if (all.empty())
    m_blocks.erase(before);
  else
    m_blocks[block] = std::move(all);
}

}  // namespace mrpt_mapconv::freespace
