#pragma once

#include <string>
#include <string_view>

namespace mrpt_mapconv::files
{
inline bool beginsWith(std::string_view text, std::string_view begin)
{
  return text.substr(0, begin.size()) == begin;
}

/** Whether a line of the text begins so. */
inline bool hasLine(std::string_view text, std::string_view begin)
{
  return beginsWith(text, begin) || text.find("\n" + std::string(begin)) != std::string_view::npos;
}

/** Without the mark that editors put before a text. */
inline std::string_view withoutMark(std::string_view text)
{
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.substr(beginsWith(text, kMark) ? kMark.size() : 0);
}

/** Whether the bytes of a header of LAS say that its points are packed to LAZ. */
inline bool isPackedLas(std::string_view begin)
{
  constexpr std::size_t kPointFormat = 104;
  constexpr unsigned kPacked = 0x80, kPackedOfOld = 0x40;
  return begin.size() > kPointFormat &&
         (static_cast<unsigned char>(begin[kPointFormat]) & (kPacked | kPackedOfOld)) != 0;
}

}  // namespace mrpt_mapconv::files
