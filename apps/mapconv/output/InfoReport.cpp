#include "output/InfoReport.h"

#include <mrpt_mapconv/params/Printable.h>

namespace mapconv
{
void InfoReport::line(const std::string& label, const std::string& text)
{
  constexpr std::size_t kLabelWidth = 12;
  const std::size_t gap = label.size() < kLabelWidth ? kLabelWidth - label.size() : 0;
  m_text += label + std::string(gap + 1, ' ') + mrpt_mapconv::params::printable(text) + "\n";
}

}  // namespace mapconv
