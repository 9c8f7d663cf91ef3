#include "LowPoints.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "../grid/Parallel.h"

namespace mrpt_mapconv::aerial
{
namespace
{
constexpr std::int32_t kRadiusCells = 5;
constexpr std::size_t kLeastPoints = 10;  // around a point that is judged
constexpr std::size_t kLeastCompany = 3;  // other points

/** Heights of points over the plane that fits all used ones best: on a hillside every point has
 * lower ones around. */
class Heights
{
 public:
  Heights(const cloud::PointCloud& cloud, const UsedPoints& used) : m_cloud(cloud)
  {
    double n = 0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();  // far coordinates would cost digits
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < used.size(); ++i)
    {
      if (!used[i]) continue;
      if (n == 0) first = {cloud.x[i], cloud.y[i], cloud.z[i]};
      const Eigen::Vector3d place = Eigen::Vector3d(cloud.x[i], cloud.y[i], cloud.z[i]) - first;
      n += 1, sum += place, squares += place * place.transpose();
    }
    const Eigen::Matrix3d spread = squares / n - sum / n * (sum / n).transpose();
    m_slope = spread.topLeftCorner<2, 2>().completeOrthogonalDecomposition().solve(
        spread.topRightCorner<2, 1>());
  }
  double of(std::uint32_t point) const
  {
    return m_cloud.z[point] - m_slope.x() * m_cloud.x[point] - m_slope.y() * m_cloud.y[point];
  }

 private:
  const cloud::PointCloud& m_cloud;
  Eigen::Vector2d m_slope;  // [m/m]
};

/** The used points of a cloud, cell by cell, in each from the lowest up. */
struct SortedPoints
{
  grid::GridFrame frame;
  std::vector<std::size_t> begin;  // of a cell in `points`; one more at the end
  std::vector<std::uint32_t> points;

  std::size_t count(std::size_t cell) const { return begin[cell + 1] - begin[cell]; }
};

SortedPoints sortPoints(const cloud::PointCloud& cloud, const UsedPoints& used,
                        const Heights& heights, double resolution, int threads)
{
  SortedPoints sorted;
  sorted.frame = frameAround(cloud, used, {resolution, "lowPointRadius / 5"});
  sorted.begin.assign(sorted.frame.size() + 1, 0);
  const auto forEachUsed = [&](const auto& visit)
  {
    for (std::uint32_t i = 0; i < used.size(); ++i)
      if (used[i]) visit(i, cellAt(sorted.frame, cloud.x[i], cloud.y[i]));
  };
  forEachUsed([&](std::uint32_t, std::size_t cell) { ++sorted.begin[cell + 1]; });
  std::partial_sum(sorted.begin.begin(), sorted.begin.end(), sorted.begin.begin());
  sorted.points.resize(sorted.begin.back());
  std::vector<std::size_t> next(sorted.begin.begin(), sorted.begin.end() - 1);
  forEachUsed([&](std::uint32_t i, std::size_t cell) { sorted.points[next[cell]++] = i; });
  grid::inParallel(sorted.frame.size(), threads,
                   [&](std::size_t first, std::size_t last)
                   {
                     const auto at = [&](std::size_t cell)
                     { return sorted.points.begin() + static_cast<std::ptrdiff_t>(cell); };
                     for (std::size_t cell = first; cell < last; ++cell)
                       std::sort(at(sorted.begin[cell]), at(sorted.begin[cell + 1]),
                                 [&](std::uint32_t a, std::uint32_t b)
                                 { return heights.of(a) < heights.of(b); });
                   });
  return sorted;
}

/** The cells within the radius around a cell, itself among them, as far as the frame has them. */
void cellsAround(const grid::GridFrame& frame, std::size_t cell, std::vector<std::size_t>& cells)
{
  cells.clear();
  const auto width = static_cast<std::size_t>(frame.width);
  const auto ix = static_cast<std::int32_t>(cell % width);
  const auto iy = static_cast<std::int32_t>(cell / width);
  for (std::int32_t dy = -kRadiusCells; dy <= kRadiusCells; ++dy)
    for (std::int32_t dx = -kRadiusCells; dx <= kRadiusCells; ++dx)
      if (dx * dx + dy * dy <= kRadiusCells * kRadiusCells &&
          frame.containsKey(frame.x0 + ix + dx, frame.y0 + iy + dy))
        cells.push_back(frame.indexOfKey(frame.x0 + ix + dx, frame.y0 + iy + dy));
}

/** Whether more than `enough` points of the cells are company of a point of height z, itself among
 * them. */
bool hasCompany(const Heights& heights, const SortedPoints& sorted,
                const std::vector<std::size_t>& cells, double z, const Company& where,
                std::size_t enough)
{
  std::size_t company = 0;
  for (const std::size_t cell : cells)
    for (std::size_t k = sorted.begin[cell]; k < sorted.begin[cell + 1]; ++k)
    {
      const double other = heights.of(sorted.points[k]);
      if (other > z + where.above) break;
      if (other >= z - where.below && ++company > enough) return true;
    }
  return false;
}

}  // namespace

Company Company::of(const GroundParams& params, double pointDistance)
{
  constexpr double kLeastDistances = 4, kSteepest = 0.5;
  const double scale = std::max(1.0, kLeastDistances * pointDistance / params.lowPointRadius);
  const double radius = scale * params.lowPointRadius;
  return {radius, kSteepest * radius, scale * params.lowPointDepth};
}

void leaveOutLowPoints(const cloud::PointCloud& cloud, const GroundParams& params, int threads,
                       UsedPoints& used)
{
  if (params.lowPointRadius <= 0) return;
  const auto company = Company::of(params, meanDistance(cloud, used));
  const UsedPoints before = used;
  const Heights heights(cloud, used);
  const SortedPoints sorted =
      sortPoints(cloud, used, heights, company.radius / kRadiusCells, threads);
  const auto judgeCell = [&](std::size_t cell, std::vector<std::size_t>& around)
  {
    cellsAround(sorted.frame, cell, around);
    std::size_t points = 0;
    for (const std::size_t other : around) points += sorted.count(other);
    if (points < kLeastPoints) return;
    const auto enough = kLeastCompany + static_cast<std::size_t>(params.lowPointShare *
                                                                 static_cast<double>(points));
    for (std::size_t k = sorted.begin[cell]; k < sorted.begin[cell + 1]; ++k)
    {
      const std::uint32_t point = sorted.points[k];
      if (hasCompany(heights, sorted, around, heights.of(point), company, enough)) return;
      used[point] = 0;
    }
  };
  grid::inParallel(sorted.frame.size(), threads,
                   [&](std::size_t first, std::size_t last)
                   {
                     std::vector<std::size_t> around;
                     for (std::size_t cell = first; cell < last; ++cell)
                       if (sorted.count(cell) > 0) judgeCell(cell, around);
                   });
  if (std::find(used.begin(), used.end(), 1) == used.end()) used = before;
}

}  // namespace mrpt_mapconv::aerial
