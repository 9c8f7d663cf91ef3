#include "BlockInput.h"

#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace mrpt_mapconv::cloud
{
namespace
{
constexpr std::size_t kBlock = std::size_t(1) << 18U, kLongestLine = std::size_t(1) << 20U;
}

BlockInput::BlockInput(files::InputStream& stream) : m_stream(stream) {}

/** Has `size` bytes at least lie in the buffer. \return false if the file ends before */
bool BlockInput::fill(std::size_t size)
{
  std::memmove(m_buffer.data(), m_buffer.data() + m_begin, m_end - m_begin);
  m_end -= m_begin;
  m_begin = 0;
  m_buffer.resize(std::max({m_buffer.size(), kBlock, size}));
  m_end += m_stream.read(&m_buffer[m_end], m_buffer.size() - m_end);
  if (m_end < m_buffer.size() && !m_stream.error().empty())
    fail("is truncated or damaged: " + m_stream.error());
  return m_end >= size;
}

std::string BlockInput::bytes(std::uint64_t most)
{
  std::string all;
  while (all.size() < most)
  {
    if (m_begin == m_end && !fill(1)) break;
    const auto piece =
        static_cast<std::size_t>(std::min<std::uint64_t>(most - all.size(), m_end - m_begin));
    all.append(take(piece), piece);
  }
  return all;
}

bool BlockInput::skip(std::uint64_t size)
{
  while (size > 0)
  {
    if (m_begin == m_end && !fill(1)) return false;
    const auto piece = std::min<std::uint64_t>(size, m_end - m_begin);
    take(static_cast<std::size_t>(piece));
    size -= piece;
  }
  return true;
}

std::optional<std::string_view> BlockInput::line()
{
  const auto end = [this](std::size_t from)
  { return std::string_view(m_buffer.data(), m_end).find('\n', m_begin + from); };
  auto stop = end(0);
  while (stop == std::string_view::npos)
  {
    const std::size_t known = m_end - m_begin;
    if (known > kLongestLine) fail("line " + std::to_string(m_lines + 1) + " is longer than 1 MB");
    if (!fill(known + 1)) break;
    stop = end(known);
  }
  const bool isLast = stop == std::string_view::npos;
  const std::size_t size = isLast ? m_end - m_begin : stop + 1 - m_begin;
  if (size == 0) return {};
  ++m_lines;
  std::string_view text(take(size), size);
  if (!isLast) text.remove_suffix(1);
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return text;
}

void BlockInput::fail(const std::string& what) const
{
  throw std::runtime_error(name() + ": " + what);
}

void BlockInput::failLine(const std::string& what) const
{
  fail("line " + std::to_string(m_lines) + ": " + what);
}

void BlockInput::failTruncated(std::uint64_t promised, std::uint64_t found) const
{
  fail("is truncated: its header promises " + params::counted(promised, "point") +
       ", of which the file has " + std::to_string(found));
}

}  // namespace mrpt_mapconv::cloud
