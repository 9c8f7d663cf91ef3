#include "PointBatch.h"

#include <mrpt/core/format.h>
#include <mrpt_mapconv/observation/FinitePose.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "../grid/Wide.h"
#include "Tile.h"

namespace mrpt_mapconv::terrain
{
namespace
{
using Coefficients = PointModel::Coefficients;
using Batch = PointModel::Batch;
constexpr double kMostKey = 1 << 30;
constexpr double kMostHeight = 32000;  // [m]: differences have 31 bits of kHeightUnit

/** J of z by roll or pitch is linear in the point: d(row·(R p + t)) = (row R)·p + row·t. */
void setDerivative(const double (&row)[3], const mrpt::math::CMatrixDouble33& r,
                   const mrpt::math::TPoint3D& t, float (&out)[4])
{
  for (int column = 0; column < 3; ++column)
    out[column] =
        static_cast<float>(row[0] * r(0, column) + row[1] * r(1, column) + row[2] * r(2, column));
  out[3] = static_cast<float>(row[0] * t.x + row[1] * t.y + row[2] * t.z);
}

inline std::int32_t floorOf(double v)
{
  const auto cut = static_cast<std::int32_t>(v);
  return cut - (static_cast<double>(cut) > v ? 1 : 0);
}

/** Points that are not finite become the sensor's place with weight 0. */
MRPT_MAPCONV_WIDE
void cleanPoints(float* x, float* y, float* z, float* finite, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const float none = x[i] * 0 + y[i] * 0 + z[i] * 0;  // NaN for NaN and infinity
    const bool ok = none == 0;
    x[i] = ok ? x[i] : 0.0f;
    y[i] = ok ? y[i] : 0.0f;
    z[i] = ok ? z[i] : 0.0f;
    finite[i] = ok ? 1.0f : 0.0f;
  }
}

void copyOut(const float* from, std::size_t first, std::size_t count, std::size_t stride, float* to)
{
  if (stride == 1)
    std::copy_n(from + first, count, to);
  else
    for (std::size_t i = 0; i < count; ++i) to[i] = from[(first + i) * stride];
}

MRPT_MAPCONV_WIDE
void computeCells(const Coefficients& c, const float* __restrict x, const float* __restrict y,
                  const float* __restrict z, std::size_t count, std::int32_t* __restrict kx,
                  std::int32_t* __restrict ky, std::int32_t* __restrict height)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const double px = x[i], py = y[i], pz = z[i];
    const double mx = c.rows[0][0] * px + c.rows[0][1] * py + c.rows[0][2] * pz + c.shift[0];
    const double my = c.rows[1][0] * px + c.rows[1][1] * py + c.rows[1][2] * pz + c.shift[1];
    const double mz = c.rows[2][0] * px + c.rows[2][1] * py + c.rows[2][2] * pz + c.shift[2];
    kx[i] = floorOf(mx / c.resolution + 0.5);
    ky[i] = floorOf(my / c.resolution + 0.5);
    height[i] = floorOf(mz / kHeightUnit + 0.5);
  }
}

/** σ_h² = J_S Σ_S J_Sᵀ + J_P Σ_P J_Pᵀ. The third row of the rotation is J_S; of a point p at range
 * r and u = J_S·p above the sensor, the beam's share of J_S is u/r. */
inline float varianceOf(const Coefficients& c, float x, float y, float z)
{
  const float r2 = x * x + y * y + z * z;
  const float u = c.up[0] * x + c.up[1] * y + c.up[2] * z;
  const float u2 = u * u;
  const float roll = c.roll[0] * x + c.roll[1] * y + c.roll[2] * z + c.roll[3];
  const float pitch = c.pitch[0] * x + c.pitch[1] * y + c.pitch[2] * z + c.pitch[3];
  const float ofPose = c.pose[0] + roll * (roll * c.pose[1] + c.pose[3] + pitch * c.pose[5]) +
                       pitch * (pitch * c.pose[2] + c.pose[4]);
  const float ofSensor = c.range * (u2 / (r2 + 1e-12f)) + c.beam * (r2 - u2);
  return ofSensor + ofPose;
}

MRPT_MAPCONV_WIDE
void computeWeights(const Coefficients& c, const float* __restrict x, const float* __restrict y,
                    const float* __restrict z, const float* __restrict finite, std::size_t count,
                    std::int32_t* __restrict weight)
{
  constexpr auto kLeast = static_cast<float>(kLeastSigma * kLeastSigma);
  constexpr float kMost = kWeightUnit;  // of 1 in this unit
  for (std::size_t i = 0; i < count; ++i)
  {
    const float variance = varianceOf(c, x[i], y[i], z[i]);
    const float bounded =
        variance < kMost ? (variance < kLeast ? kLeast : variance) : kMost;  // NaN: too
    weight[i] = static_cast<std::int32_t>(static_cast<float>(kWeightUnit) / bounded * finite[i] +
                                          0.5f * finite[i]);
  }
}

/** The largest magnitude of the finite numbers: magnitudes are ordered as their bits are. */
MRPT_MAPCONV_WIDE
float largest(const float* __restrict v, std::size_t count)
{
  constexpr std::int32_t kInfinity = 0x7F800000;
  std::int32_t most = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    std::int32_t bits;
    std::memcpy(&bits, v + i, sizeof(bits));
    const std::int32_t magnitude = bits & 0x7FFFFFFF;
    const std::int32_t finite = magnitude < kInfinity ? magnitude : 0;
    most = finite > most ? finite : most;
  }
  float out;
  std::memcpy(&out, &most, sizeof(out));
  return out;
}

void requireInRange(const mrpt::math::TPoint3D& p, double resolution)
{
  const double most = kMostKey * resolution;
  if (std::abs(p.x) < most && std::abs(p.y) < most && std::abs(p.z) < kMostHeight) return;
  throw std::runtime_error(mrpt::format(
      "terrain: a place at (%.1f, %.1f, %.1f) m lies beyond the map's range, +-%.0f m across and "
      "+-%.0f m in height: move the poses nearer to the origin",
      p.x, p.y, p.z, most, kMostHeight));
}

void checkCovariance(const mrpt::math::CMatrixDouble33& covariance)
{
  static const char* const kNames[] = {"z", "roll", "pitch"};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      constexpr double kMost = 1e6;  // [m², rad²]
      const double v = covariance(i, j), limit = covariance(i, i) * covariance(j, j);
      if (std::abs(v) <= kMost && (i == j ? v >= 0 : v * v <= limit * (1 + 1e-9) + 1e-30)) continue;
      throw std::invalid_argument(std::string("terrain: the covariance of the pose's ") +
                                  kNames[i] + " and " + kNames[j] + " = " + std::to_string(v) +
                                  " is not valid: a covariance matrix is needed");
    }
}
}  // namespace

PointModel::PointModel(const TerrainScan& scan, const PointSigmas& sigmas, double resolution)
    : m_scan(scan)
{
  sigmas.check();
  checkCovariance(scan.poseCovariance);
  if (!observation::isFinite(scan.sensorPose) || !observation::isFinite(scan.robotPose))
    throw std::invalid_argument("terrain: the pose of a scan is not finite");
  const auto r = scan.sensorPose.getRotationMatrix();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m_c.rows[i][j] = r(i, j);
  m_c.shift[0] = scan.sensorPose.x();
  m_c.shift[1] = scan.sensorPose.y();
  m_c.shift[2] = scan.sensorPose.z();
  m_c.resolution = resolution;
  for (int j = 0; j < 3; ++j) m_c.up[j] = static_cast<float>(r(2, j));

  // z = t_z + (−sin p, cos p sin r, cos p cos r)·q, with q in the robot's frame
  const mrpt::poses::CPose3D onRobot = scan.sensorPose - scan.robotPose;
  const auto ofSensor = onRobot.getRotationMatrix();
  const mrpt::math::TPoint3D t(onRobot.x(), onRobot.y(), onRobot.z());
  const double sp = std::sin(scan.robotPose.pitch()), cp = std::cos(scan.robotPose.pitch()),
               sr = std::sin(scan.robotPose.roll()), cr = std::cos(scan.robotPose.roll());
  setDerivative({0, cp * cr, -cp * sr}, ofSensor, t, m_c.roll);
  setDerivative({-cp, -sp * sr, -sp * cr}, ofSensor, t, m_c.pitch);

  const auto square = [](double v) { return static_cast<float>(v * v); };
  m_c.range = square(sigmas.range);
  m_c.beam = square(sigmas.beam);
  const auto& p = scan.poseCovariance;
  const double pose[] = {p(0, 0), p(1, 1), p(2, 2), 2 * p(0, 1), 2 * p(0, 2), 2 * p(1, 2)};
  std::transform(std::begin(pose), std::end(pose), m_c.pose,
                 [](double v) { return static_cast<float>(v); });
}

void PointModel::compute(std::size_t first, std::size_t count, Batch& out) const
{
  float x[kBatch], y[kBatch], z[kBatch], finite[kBatch];
  copyOut(m_scan.x, first, count, m_scan.stride, x);
  copyOut(m_scan.y, first, count, m_scan.stride, y);
  copyOut(m_scan.z, first, count, m_scan.stride, z);
  cleanPoints(x, y, z, finite, count);
  computeCells(m_c, x, y, z, count, out.kx.data(), out.ky.data(), out.z.data());
  computeWeights(m_c, x, y, z, finite, count, out.weight.data());
}

double PointModel::variance(float x, float y, float z) const
{
  return static_cast<double>(varianceOf(m_c, x, y, z));
}

PointModel::Place PointModel::placeOf(double x, double y, double z, double resolution)
{
  requireInRange({x, y, z}, resolution);
  return {floorOf(x / resolution + 0.5), floorOf(y / resolution + 0.5),
          floorOf(z / kHeightUnit + 0.5)};
}

std::uint32_t PointModel::weightOf(double variance)
{
  const double bounded = std::clamp(variance, kLeastSigma * kLeastSigma, kWeightUnit);
  return static_cast<std::uint32_t>(kWeightUnit / bounded + 0.5);
}

/** The largest magnitude of a coordinate; of points side by side in memory, of all of them. */
double PointModel::mostOf(const float* v) const
{
  if (m_scan.points == 0) return 0;
  return static_cast<double>(largest(v, (m_scan.points - 1) * m_scan.stride + 1));
}

void PointModel::checkRange() const
{
  const auto& robot = m_scan.robotPose;
  requireInRange({robot.x(), robot.y(), robot.z()}, m_c.resolution);
  const double reach = std::hypot(mostOf(m_scan.x), mostOf(m_scan.y), mostOf(m_scan.z));
  const double across = std::max(std::abs(m_c.shift[0]), std::abs(m_c.shift[1]));
  if (across + reach < kMostKey * m_c.resolution && std::abs(m_c.shift[2]) + reach < kMostHeight)
    return;
  for (std::size_t i = 0; i < m_scan.points; ++i)
  {
    const std::size_t at = i * m_scan.stride;
    const mrpt::math::TPoint3D local(static_cast<double>(m_scan.x[at]),
                                     static_cast<double>(m_scan.y[at]),
                                     static_cast<double>(m_scan.z[at]));
    if (std::isfinite(local.x + local.y + local.z))
      requireInRange(m_scan.sensorPose.composePoint(local), m_c.resolution);
  }
}

}  // namespace mrpt_mapconv::terrain
