#include <mrpt_mapconv/freespace/OpenColumns.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace mrpt_mapconv::freespace
{
namespace
{
bool isBefore(const OpenColumn& a, const OpenColumn& b) { return a.column < b.column; }
}  // namespace

std::optional<OpenColumn> OpenColumns::at(voxel::BlockKey block, std::int32_t column) const
{
  const auto found = m_blocks.find(block);
  if (found == m_blocks.end()) return std::nullopt;
  const Columns& all = found->second;
  const auto it = std::lower_bound(all.begin(), all.end(),
                                   OpenColumn{static_cast<std::uint16_t>(column)}, isBefore);
  return it != all.end() && it->column == column ? std::optional(*it) : std::nullopt;
}

std::optional<OpenColumn> OpenColumns::at(std::int32_t kx, std::int32_t ky) const
{
  // blocks begin at multiples of their side, also below 0
  constexpr std::int32_t side = voxel::kBlockSide, last = side - 1;
  return at({(kx - (kx & last)) / side, (ky - (ky & last)) / side},
            side * (ky & last) + (kx & last));
}

void OpenColumns::replace(voxel::BlockKey block, const voxel::ColumnMask& columns,
                          const std::vector<OpenColumn>& found)
{
  const auto before = m_blocks.find(block);
  if (before == m_blocks.end() && found.empty()) return;
  Columns kept;
  const auto isOther = [&columns](const OpenColumn& open)
  {
    const std::uint32_t row = columns[static_cast<std::size_t>(open.column / voxel::kBlockSide)];
    return (row >> (open.column % voxel::kBlockSide) & 1U) == 0;
  };
  if (before != m_blocks.end())
    std::copy_if(before->second.begin(), before->second.end(), std::back_inserter(kept), isOther);
  Columns all(kept.size() + found.size());
  std::merge(kept.begin(), kept.end(), found.begin(), found.end(), all.begin(), isBefore);
  if (all.empty())
    m_blocks.erase(before);
  else
    m_blocks[block] = std::move(all);
}

}  // namespace mrpt_mapconv::freespace
