#include "SectionKeys.h"

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::sim
{
namespace
{
// beyond it single precision, which rays have, is worth less than a decimetre
constexpr double kFarthest = 1e6;

void requireNear(params::StrictSection& section, const std::string& key, const std::string& meaning,
                 const std::vector<double>& numbers)
{
  for (const double number : numbers)
    if (std::abs(number) > kFarthest) section.fail(key, meaning + ", within +-1e6");
}
}  // namespace

void require(params::StrictSection& section, const std::string& key, const std::string& meaning)
{
  if (!section.has(key)) section.fail(key, "given: " + meaning);
}

std::vector<double> readNumbers(params::StrictSection& section, const std::string& key,
                                std::size_t count, const std::string& meaning)
{
  require(section, key, meaning);
  std::vector<double> numbers;
  section.read(key, numbers);
  if (numbers.size() != count) section.fail(key, meaning);
  requireNear(section, key, meaning, numbers);
  return numbers;
}

double readNumber(params::StrictSection& section, const std::string& key)
{
  return readNumbers(section, key, 1, "one number")[0];
}

double readPositive(params::StrictSection& section, const std::string& key)
{
  const double number = readNumbers(section, key, 1, "a number > 0")[0];
  if (!(number > 0)) section.fail(key, "a number > 0");
  return number;
}

double readPositive(params::StrictSection& section, const std::string& key, double otherwise)
{
  return section.has(key) ? readPositive(section, key) : otherwise;
}

double readShare(params::StrictSection& section, const std::string& key)
{
  double share = 0;
  section.read(key, share);
  if (!(share >= 0 && share <= 1)) section.fail(key, "within 0 and 1");
  return share;
}

mrpt::math::TPoint2D readPoint2D(params::StrictSection& section, const std::string& key)
{
  const auto v = readNumbers(section, key, 2, "two numbers, x y [m]");
  return {v[0], v[1]};
}

mrpt::math::TPoint3D readPoint3D(params::StrictSection& section, const std::string& key)
{
  const auto v = readNumbers(section, key, 3, "three numbers, x y z [m]");
  return {v[0], v[1], v[2]};
}

std::vector<mrpt::math::TPoint2D> readLine(params::StrictSection& section, const std::string& key)
{
  const std::string meaning = "two or more points, x y x y ... [m]";
  require(section, key, meaning);
  std::vector<double> v;
  section.read(key, v);
  if (v.size() < 4 || v.size() % 2 != 0) section.fail(key, meaning);
  requireNear(section, key, meaning, v);
  std::vector<mrpt::math::TPoint2D> line;
  for (std::size_t i = 0; i < v.size(); i += 2) line.emplace_back(v[i], v[i + 1]);
  return line;
}

Interval readInterval(params::StrictSection& section, const std::string& key)
{
  const std::string meaning = "two numbers, lowest and highest, 0 < lowest <= highest";
  const auto v = readNumbers(section, key, 2, meaning);
  if (!(v[0] > 0 && v[0] <= v[1])) section.fail(key, meaning);
  return {v[0], v[1]};
}

Outline readOutline(params::StrictSection& section)
{
  const Outline area{readPoint2D(section, "min"), readPoint2D(section, "max")};
  if (!(area.min.x < area.max.x && area.min.y < area.max.y))
    section.fail("max", "above min in x and y");
  return area;
}

Corners readCorners(params::StrictSection& section)
{
  const Corners corners{readPoint3D(section, "min"), readPoint3D(section, "max")};
  for (int axis = 0; axis < 3; ++axis)
    if (!(corners.min[axis] < corners.max[axis]))
      section.fail("max", std::string("above min in ") + "xyz"[axis]);
  return corners;
}

Direction readDirection(params::StrictSection& section)
{
  require(section, "direction", "+x or -x or +y or -y");
  int index = 0;
  section.readChoice("direction", {"+x", "-x", "+y", "-y"}, index);
  return {index >= 2, index % 2 == 1};
}

}  // namespace mrpt_mapconv::sim
