// A room mapped at any angle to the grid's axes is mapped equally well.
#include <gtest/gtest.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace
{
using namespace mrpt_mapconv;
using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;
using mrpt::math::TPoint3Df;
using mrpt::poses::CPose3D;

constexpr double kResolution = 0.05;
constexpr double kRadians = 3.14159265358979323846 / 180;

/** Something upright that stands on the floor. */
struct Box
{
  double xMin, yMin, xMax, yMax, height;

  bool contains(const TPoint2D& p) const
  {
    return p.x >= xMin && p.x <= xMax && p.y >= yMin && p.y <= yMax;
  }
};

constexpr Box kRoom{0.02, 0.01, 8.03, 6.02, 2.7};
constexpr Box kBoxes[] = {{-0.2, -0.2, 8.25, 0.01, 2.7},  {-0.2, 6.02, 8.25, 6.25, 2.7},  // walls
                          {-0.2, -0.2, 0.02, 6.25, 2.7},  {8.03, -0.2, 8.25, 6.25, 2.7},
                          {2.01, 1.52, 3.23, 2.24, 0.72},  // a table, a shelf, a pillar, a stool
                          {7.62, 1.03, 8.03, 2.61, 1.42}, {5.03, 3.81, 5.34, 4.13, 2.7},
                          {3.62, 4.43, 4.01, 4.84, 0.43}};
constexpr TPoint2D kPlaces[] = {{1.013, 1.027}, {6.541, 1.233}, {4.017, 3.291},
                                {1.231, 4.917}, {6.823, 5.187}, {2.619, 3.533}};
constexpr double kSensorHeight = 1.39;

/** Where a ray from outside of a box enters it. */
std::optional<double> entry(const Box& box, const TPoint3D& from, const TPoint3D& direction)
{
  const double low[] = {box.xMin, box.yMin, 0}, high[] = {box.xMax, box.yMax, box.height};
  double begin = 0, end = 100;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = (low[axis] - from[axis]) / direction[axis];
    const double b = (high[axis] - from[axis]) / direction[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return begin < end ? std::optional<double>(begin) : std::nullopt;
}

/** What a lidar sees from a place, in its own frame, which is not turned. */
std::vector<TPoint3Df> scanFrom(const TPoint2D& place)
{
  std::vector<TPoint3Df> points;
  const TPoint3D from(place.x, place.y, kSensorHeight);
  for (double azimuth = 0.1; azimuth < 360; azimuth += 0.35)
    for (double elevation = -44.9; elevation < 45; elevation += 1.5)
    {
      const double a = azimuth * kRadians, e = elevation * kRadians;
      const TPoint3D ray(std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e));
      std::optional<double> nearest;
      for (const Box& box : kBoxes)
        if (const auto range = entry(box, from, ray); range && (!nearest || *range < *nearest))
          nearest = range;
      if (nearest) points.emplace_back(ray * *nearest);
    }
  return points;
}

/** The room's map when the world is turned about the origin. */
struct RoomMap
{
  grid::GridFrame frame{kResolution, -250, -250, 500, 500};
  std::vector<std::int8_t> cells = std::vector<std::int8_t>(frame.size(), 0);
};

RoomMap mapAt(double angle)
{
  RoomMap map;
  scan::ProfileParams params;
  params.structureMinZ = 2.3;
  params.structureMaxZ = 2.6;
  scan::ScanProfile profile;
  for (const TPoint2D& place : kPlaces)
  {
    scan::Viewpoint view;
    view.sensorPose =
        CPose3D(0, 0, 0, angle, 0, 0) + CPose3D(place.x, place.y, kSensorHeight, 0, 0, 0);
    view.azimuthStep = 0.35 * kRadians;
    profile.compute(scanFrom(place), view, kResolution, params);
    scan::LogOddsUpdate().apply(profile, map.frame, map.cells.data());
  }
  return map;
}

enum class Truth
{
  Outside,
  Free,
  Occupied  //!< at least a part of the cell
};

Truth truthOf(int kx, int ky, double angle)
{
  constexpr int kParts = 8;
  const CPose3D world(0, 0, 0, angle, 0, 0);
  bool inside = false;
  for (int i = 0; i < kParts * kParts; ++i)
  {
    const TPoint3D p =
        world.inverseComposePoint(TPoint3D((kx + (i % kParts + 0.5) / kParts) * kResolution,
                                           (ky + (i / kParts + 0.5) / kParts) * kResolution, 0));
    for (const Box& box : kBoxes)
      if (box.contains({p.x, p.y})) return Truth::Occupied;
    inside = inside || kRoom.contains({p.x, p.y});
  }
  return inside ? Truth::Free : Truth::Outside;
}

std::vector<Truth> truthAt(const grid::GridFrame& frame, double angle)
{
  std::vector<Truth> truth;
  for (int ky = frame.y0; ky < frame.yEnd(); ++ky)
    for (int kx = frame.x0; kx < frame.xEnd(); ++kx) truth.push_back(truthOf(kx, ky, angle));
  return truth;
}

/** Free cells, and occupied ones that have a free one among the eight around them. */
bool shouldBeLabelled(const std::vector<Truth>& truth, std::size_t cell, int width)
{
  if (truth[cell] != Truth::Occupied) return truth[cell] == Truth::Free;
  for (const int dy : {-width, 0, width})
    for (const int dx : {-1, 0, 1})
    {
      const auto next = static_cast<std::ptrdiff_t>(cell) + dy + dx;
      if (next >= 0 && next < static_cast<std::ptrdiff_t>(truth.size()) &&
          truth[static_cast<std::size_t>(next)] == Truth::Free)
        return true;
    }
  return false;
}

double fScoreAt(double angle)
{
  const RoomMap map = mapAt(angle);
  const std::vector<Truth> truth = truthAt(map.frame, angle);
  double labelled = 0, correct = 0, wanted = 0;
  for (std::size_t cell = 0; cell < truth.size(); ++cell)
  {
    const int value = map.cells[cell];
    labelled += value != 0 ? 1 : 0;
    correct += value == 0 || truth[cell] == Truth::Outside   ? 0
               : (value > 0) == (truth[cell] == Truth::Free) ? 1
                                                             : 0;
    wanted += shouldBeLabelled(truth, cell, map.frame.width) ? 1 : 0;
  }
  const double precision = correct / labelled, recall = correct / wanted;
  return 2 * precision * recall / (precision + recall);
}

TEST(ScanProfile, OtherAnglesGiveTheSameScore)
{
  const double level = fScoreAt(0);
  EXPECT_GT(level, 0.97);
  for (const double degrees : {7.0, 20.0, 33.0, 45.0, 71.0, 158.0})
    EXPECT_NEAR(fScoreAt(degrees * kRadians), level, 0.01) << degrees << " degrees";
}

}  // namespace
