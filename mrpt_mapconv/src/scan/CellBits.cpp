#include <mrpt_mapconv/scan/CellBits.h>

namespace mrpt_mapconv::scan
{
std::size_t CellBits::count() const
{
  std::size_t cells = 0;
  for (const std::uint64_t word : m_bits)
    cells += static_cast<std::size_t>(__builtin_popcountll(word));
  return cells;
}

}  // namespace mrpt_mapconv::scan
