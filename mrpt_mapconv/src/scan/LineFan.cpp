#include "LineFan.h"

#include <cmath>

namespace mrpt_mapconv::scan
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

/** The line that goes along the first axis of a quarter and across, along its second one; in the
 * first quarter these are +x and +y. */
Line lineInQuarter(int quarter, double along, double across)
{
  const bool firstIsY = quarter % 2 == 1;
  const int firstSign = quarter < 2 ? 1 : -1;
  const int secondSign = quarter == 0 || quarter == 3 ? 1 : -1;
  const double first = firstSign * along, second = secondSign * across;
  const bool firstIsMajor = across <= along;
  const double major = firstIsMajor ? along : across, minor = firstIsMajor ? across : along;
  Line line;
  line.diamondAngle = firstIsY ? diamondAngleOf(second, first) : diamondAngleOf(first, second);
  line.alongY = firstIsMajor == firstIsY;
  line.majorSign = firstIsMajor ? firstSign : secondSign;
  line.minorSign = firstIsMajor ? secondSign : firstSign;
  line.minorShare = minor / std::hypot(major, minor);
  line.majorPerMinor = major / minor;
  return line;
}
}  // namespace

double diamondAngleOf(double x, double y)
{
  const double share = y / (std::abs(x) + std::abs(y));
  if (x < 0) return 2 - share;
  return share < 0 ? 4 + share : share;
}

void LineFan::setCount(std::int32_t lines)
{
  if (lines == m_count) return;
  m_count = lines;
  m_sines.resize(static_cast<std::size_t>(lines) + 1);
  for (std::int32_t j = 0; j <= lines; ++j)
    m_sines[static_cast<std::size_t>(j)] = std::sin(kPi / 2 * j / lines);
  m_lines.clear();
  for (std::int32_t i = 0; i < lines; ++i) m_lines.push_back(makeLine(i));
}

double LineFan::step() const { return 2 * kPi / m_count; }

Line LineFan::makeLine(std::int32_t i) const
{
  // how much of its quarter lies before the line, in n-ths
  const auto quarters = std::int64_t(4) * i;
  const auto part = static_cast<std::size_t>(quarters % m_count);
  return lineInQuarter(static_cast<int>(quarters / m_count),
                       m_sines[static_cast<std::size_t>(m_count) - part], m_sines[part]);
}

Line lineTowards(double x, double y)
{
  const double alongX = std::abs(x), alongY = std::abs(y);  // never −0, whose inverse is −infinity
  if (x > 0 && y >= 0) return lineInQuarter(0, alongX, alongY);
  if (x <= 0 && y > 0) return lineInQuarter(1, alongY, alongX);
  if (x < 0) return lineInQuarter(2, alongX, alongY);
  return lineInQuarter(3, alongY, alongX);
}

std::int32_t linesFor(double range, double spacing)
{
  constexpr double kSlack = 1e-9;  // of a line
  return 4 * static_cast<std::int32_t>(std::ceil(2 * kPi * range / spacing / 4 - kSlack));
}

}  // namespace mrpt_mapconv::scan
