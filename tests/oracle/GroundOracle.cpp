#include "GroundOracle.h"

#include <mrpt_mapconv/grid/CellKey.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace mrpt_mapconv::oracle
{
using grid::GridFrame;
using grid::Layer;

namespace
{
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

bool isWithin(const GridFrame& f, int x, int y)
{
  return x >= 0 && y >= 0 && x < f.width && y < f.height;
}

template <class Work>
void forDisc(const GridFrame& f, int x, int y, int radius, const Work& work)
{
  for (int v = 0; v < f.height; ++v)
    for (int u = 0; u < f.width; ++u)
      if ((u - x) * (u - x) + (v - y) * (v - y) <= radius * radius) work(u, v);
}
}  // namespace

Layer<float> pointHeights(const cloud::PointCloud& cloud, const std::vector<std::uint8_t>& used,
                          const GridFrame& f, aerial::CollisionRule rule)
{
  Layer<float> heights(f, kNone);
  for (int y = 0; y < f.height; ++y)
    for (int x = 0; x < f.width; ++x)
    {
      auto best = std::make_tuple(std::numeric_limits<double>::infinity(), 0.0);
      const double left = f.edgeOf(f.x0 + x), low = f.edgeOf(f.y0 + y);
      for (std::size_t i = 0; i < cloud.size(); ++i)
      {
        const double u = cloud.x[i] - left, v = cloud.y[i] - low;
        if (!used[i] || u < 0 || v < 0 || u >= f.resolution || v >= f.resolution) continue;
        const double dx = cloud.x[i] - f.centreOf(f.x0 + x);
        const double dy = cloud.y[i] - f.centreOf(f.y0 + y);
        const double distance = rule == aerial::CollisionRule::Nearest ? dx * dx + dy * dy : 0;
        best = std::min(best, {distance, cloud.z[i]});
      }
      if (std::isfinite(std::get<0>(best)))
        heights.at(x, y) = static_cast<float>(std::get<1>(best));
    }
  return heights;
}

std::uint32_t nearestWithHeight(const Layer<float>& heights, std::size_t cell)
{
  const auto width = static_cast<std::int64_t>(heights.frame().width);
  const auto at = static_cast<std::int64_t>(cell);
  auto best = std::make_tuple(std::numeric_limits<std::int64_t>::max(), 0.0F, std::int64_t{0});
  for (std::int64_t other = 0; other < static_cast<std::int64_t>(heights.cells().size()); ++other)
  {
    const float z = heights.cells()[static_cast<std::size_t>(other)];
    if (std::isnan(z)) continue;
    const std::int64_t dx = other % width - at % width, dy = other / width - at / width;
    best = std::min(best, {dx * dx + dy * dy, z, other});
  }
  return static_cast<std::uint32_t>(std::get<2>(best));
}

Layer<double> membrane(const Layer<float>& heights)
{
  const GridFrame& f = heights.frame();
  Layer<double> z(f, 0);
  for (std::size_t i = 0; i < f.size(); ++i)
    if (!std::isnan(heights.cells()[i])) z.cells()[i] = heights.cells()[i];
  double moved = 1;
  while (moved > 1e-9)
  {
    moved = 0;
    for (int y = 0; y < f.height; ++y)
      for (int x = 0; x < f.width; ++x)
      {
        if (!std::isnan(heights.at(x, y))) continue;
        double sum = 0, count = 0;
        for (const auto& [u, v] : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}})
          if (isWithin(f, u, v)) sum += z.at(u, v), ++count;
        moved = std::max(moved, std::abs(sum / count - z.at(x, y)));
        z.at(x, y) = sum / count;
      }
  }
  return z;
}

Layer<float> opening(const Layer<float>& surface, int radius)
{
  const GridFrame& f = surface.frame();
  Layer<float> opened(f, 0);
  for (int y = 0; y < f.height; ++y)
    for (int x = 0; x < f.width; ++x)
    {
      float highest = -std::numeric_limits<float>::infinity();
      forDisc(f, x, y, radius,
              [&](int u, int v)
              {
                float lowest = std::numeric_limits<float>::infinity();
                forDisc(f, u, v, radius,
                        [&](int a, int b) { lowest = std::min(lowest, surface.at(a, b)); });
                highest = std::max(highest, lowest);
              });
      opened.at(x, y) = highest;
    }
  return opened;
}

std::vector<std::size_t> lonePoints(const cloud::PointCloud& cloud,
                                    const aerial::GroundParams& params, double distance)
{
  const double radius = std::max(params.lowPointRadius, 4 * distance);
  const double depth = params.lowPointDepth * radius / params.lowPointRadius;
  const double cell = radius / 5;
  const auto apart = [&](std::size_t a, std::size_t b)
  {
    const int dx = grid::cellKey(cloud.x[a], cell) - grid::cellKey(cloud.x[b], cell);
    const int dy = grid::cellKey(cloud.y[a], cell) - grid::cellKey(cloud.y[b], cell);
    return dx * dx + dy * dy;
  };
  Eigen::MatrixXd places(cloud.size(), 3);
  Eigen::VectorXd heights(cloud.size());
  for (int i = 0; i < heights.size(); ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    places.row(i) << cloud.x[at] - cloud.x[0], cloud.y[at] - cloud.y[0], 1;
    heights(i) = cloud.z[at];
  }
  heights -= places * places.completeOrthogonalDecomposition().solve(heights);
  const auto heightOf = [&](std::size_t i) { return heights(static_cast<int>(i)); };
  std::vector<char> isAlone(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    std::size_t around = 0, company = 0;
    for (std::size_t j = 0; j < cloud.size(); ++j)
    {
      if (apart(i, j) > 25) continue;
      ++around;
      if (j != i && heightOf(j) <= heightOf(i) + depth && heightOf(j) >= heightOf(i) - radius / 2)
        ++company;
    }
    const double enough = 3 + std::floor(params.lowPointShare * static_cast<double>(around));
    isAlone[i] = around >= 10 && static_cast<double>(company) < enough;
  }
  std::vector<std::size_t> lone;
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    bool allBelowAreAlone = isAlone[i] != 0;
    for (std::size_t j = 0; j < cloud.size(); ++j)
      if (apart(i, j) == 0 && heightOf(j) < heightOf(i) && !isAlone[j]) allBelowAreAlone = false;
    if (allBelowAreAlone) lone.push_back(i);
  }
  return lone;
}

namespace
{
/** The plane with the least squares to all cells. */
Layer<double> fittedPlane(const Layer<float>& surface)
{
  const GridFrame& f = surface.frame();
  Eigen::MatrixXd places(f.size(), 3);
  Eigen::VectorXd heights(f.size());
  for (int y = 0, i = 0; y < f.height; ++y)
    for (int x = 0; x < f.width; ++x, ++i)
    {
      places.row(i) << x, y, 1;
      heights(i) = surface.at(x, y);
    }
  const Eigen::VectorXd fitted = places * places.colPivHouseholderQr().solve(heights);
  Layer<double> plane(f, 0);
  for (std::size_t i = 0; i < f.size(); ++i) plane.cells()[i] = fitted(static_cast<int>(i));
  return plane;
}

class SlowCloth
{
 public:
  SlowCloth(const Layer<float>& surface, const aerial::GroundParams& params)
      : m_f(surface.frame()), m_params(params), m_plane(fittedPlane(surface))
  {
    m_surface = m_plane;
    for (std::size_t i = 0; i < m_f.size(); ++i)
      m_surface.cells()[i] = surface.cells()[i] - m_plane.cells()[i];
    m_z = Layer<double>(
        m_f, *std::min_element(m_surface.cells().begin(), m_surface.cells().end()) - 0.05);
    m_free = Layer<char>(m_f, 1);
  }

  Layer<double> settle()
  {
    Layer<double> before = m_z;
    for (int step = 0; step < m_params.maxIterations; ++step)
    {
      const Layer<double> start = m_z;
      for (std::size_t i = 0; i < m_f.size(); ++i)
        if (m_free.cells()[i])
          m_z.cells()[i] += (m_z.cells()[i] - before.cells()[i]) * (1 - m_params.damping) +
                            m_params.gravity * std::pow(m_params.timeStep, 4);
      for (int turn = 0; turn < 2; ++turn)
        for (int y = 0; y < m_f.height; ++y) pullRow(y);
      double moved = 0;
      for (std::size_t i = 0; i < m_f.size(); ++i)
      {
        if (m_free.cells()[i]) moved = std::max(moved, std::abs(m_z.cells()[i] - start.cells()[i]));
        if (m_z.cells()[i] <= m_surface.cells()[i]) continue;
        m_z.cells()[i] = m_surface.cells()[i];
        m_free.cells()[i] = 0;
      }
      before = start;
      if (moved < m_params.restMove) break;
    }
    for (std::size_t i = 0; i < m_f.size(); ++i) m_z.cells()[i] += m_plane.cells()[i];
    return m_z;
  }

 private:
  void pullRow(int y)
  {
    for (const int reach : {1, 2})
    {
      const Layer<double> old = m_z;
      for (int x = 0; x + reach < m_f.width; ++x) pull(old, x, y, x + reach, y);
      for (int x = 0; x < m_f.width; ++x) pull(m_z, x, y, x, y + reach);
      for (int x = 0; x < m_f.width; ++x) pull(m_z, x, y, x + reach, y + reach);
      for (int x = 0; x < m_f.width; ++x) pull(m_z, x, y, x - reach, y + reach);
    }
  }
  /** Moves both ends, if there are two, by 0.3 of their difference, `rigidness` times. */
  void pull(const Layer<double>& from, int ax, int ay, int bx, int by)
  {
    if (!isWithin(m_f, ax, ay) || !isWithin(m_f, bx, by)) return;
    double a = from.at(ax, ay), b = from.at(bx, by);
    const double startA = a, startB = b;
    const bool movesA = m_free.at(ax, ay) != 0, movesB = m_free.at(bx, by) != 0;
    for (int pass = 0; pass < m_params.rigidness; ++pass)
    {
      const double move = 0.3 * (b - a);
      if (movesA) a += move;
      if (movesB) b -= move;
    }
    m_z.at(ax, ay) += a - startA;
    m_z.at(bx, by) += b - startB;
  }

  const GridFrame& m_f;
  const aerial::GroundParams& m_params;
  Layer<double> m_plane, m_surface;  // the latter above the plane
  Layer<double> m_z;
  Layer<char> m_free;
};
}  // namespace

Layer<double> settledCloth(const Layer<float>& surface, const aerial::GroundParams& params)
{
  return SlowCloth(surface, params).settle();
}

}  // namespace mrpt_mapconv::oracle
