#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace mrpt_mapconv::test
{
/** Random bodies with level faces at multiples of 0.1 m, as a file and as an answer to "solid?". */
class RandomBodies
{
 public:
  explicit RandomBodies(unsigned seed) : m_random(seed)
  {
    for (int i = 0; i < 14; ++i) i % 3 == 0 ? addCylinder() : addBox(i % 3 == 1);
  }

  std::string text() const { return m_text.str(); }
  bool isSolid(double x, double y, double z) const
  {
    for (const auto& body : m_bodies)
      if (body(x, y, z)) return true;
    return false;
  }

 private:
  double between(double low, double high)
  {
    // a few digits, so that the file says the same as the number
    return std::round(std::uniform_real_distribution<>(low, high)(m_random) * 1e4) / 1e4;
  }
  struct ZRange
  {
    int bottom, top;  // [0.1 m]
  };
  ZRange zRange(bool low)
  {
    const int bottom = low ? -6 : std::uniform_int_distribution<>(-6, 22)(m_random);
    return {bottom, bottom + std::uniform_int_distribution<>(1, low ? 12 : 10)(m_random)};
  }
  void addBox(bool low)
  {
    const ZRange z = zRange(low);
    const double x = between(-1, 2), y = between(-1, 2), w = between(0.1, 3), l = between(0.1, 3);
    m_text << "[box.b" << m_bodies.size() << "]\nmin = " << x << ' ' << y << ' ' << z.bottom * 0.1
           << "\nmax = " << x + w << ' ' << y + l << ' ' << z.top * 0.1 << '\n';
    m_bodies.emplace_back(
        [=](double px, double py, double pz)
        {
          return px >= x && px <= x + w && py >= y && py <= y + l && pz > z.bottom * 0.1 &&
                 pz < z.top * 0.1;
        });
  }
  void addCylinder()
  {
    const ZRange z = zRange(false);
    const double x = between(0, 2), y = between(0, 2), r = between(0.05, 0.8);
    m_text << "[cylinder.c" << m_bodies.size() << "]\nbase = " << x << ' ' << y << ' '
           << z.bottom * 0.1 << "\nradius = " << r << "\nheight = " << (z.top - z.bottom) * 0.1
           << '\n';
    m_bodies.emplace_back(
        [=](double px, double py, double pz)
        { return std::hypot(px - x, py - y) <= r && pz > z.bottom * 0.1 && pz < z.top * 0.1; });
  }

  std::mt19937 m_random;
  std::ostringstream m_text;
  std::vector<std::function<bool(double, double, double)>> m_bodies;
};
}  // namespace mrpt_mapconv::test
