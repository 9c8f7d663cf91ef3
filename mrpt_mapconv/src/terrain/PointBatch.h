#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <array>
#include <cstdint>

namespace mrpt_mapconv::terrain
{
/** How points of a scan become cells, heights and weights. */
class PointModel
{
 public:
  PointModel(const TerrainScan& scan, const PointSigmas& sigmas, double resolution);

  static constexpr std::size_t kBatch = 256;
  struct Batch
  {
    std::array<std::int32_t, kBatch> kx, ky, z;
    std::array<std::int32_t, kBatch> weight;  //!< 0: the point is not finite
  };
  /** Points first … first + count − 1 of the scan. \param count at most kBatch */
  void compute(std::size_t first, std::size_t count, Batch& out) const;

  /** \exception std::runtime_error naming the place if a point lies beyond the range of keys or
   * heights */
  void checkRange() const;

  /** Where a point of the map's frame [m] goes.
   * \exception std::runtime_error as checkRange() */
  struct Place
  {
    std::int32_t kx, ky, z;
  };
  static Place placeOf(double x, double y, double z, double resolution);
  /** \param variance [m²] */
  static std::uint32_t weightOf(double variance);

  /** The variance of a point's height, σ_h² [m²]. \param x,y,z in the sensor's frame [m] */
  double variance(float x, float y, float z) const;

  /** What does not depend on the point: rows of the pose, variances. */
  struct Coefficients
  {
    double rows[3][3];  //!< rotation, sensor -> map
    double shift[3];    //!< [m]
    double resolution;
    // float: a variance needs no more
    float up[3];              //!< the third row
    float roll[4], pitch[4];  //!< derivatives of z: factors of x, y, z and the constant
    float range, beam;        //!< variances
    float pose[6];            //!< zz, rr, pp, 2 zr, 2 zp, 2 rp
  };

 private:
  double mostOf(const float* v) const;

  const TerrainScan& m_scan;
  Coefficients m_c;
};

}  // namespace mrpt_mapconv::terrain
