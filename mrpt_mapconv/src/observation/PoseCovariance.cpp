#include <mrpt_mapconv/observation/PoseCovariance.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

namespace mrpt_mapconv::observation
{
std::optional<HeightCovariance> heightCovariance(const mrpt::math::CMatrixDouble66& pose)
{
  constexpr std::array<int, 3> kZRollPitch{2, 5, 4};
  HeightCovariance out;
  bool isKnown = false;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
    {
      const double value = pose(kZRollPitch.at(static_cast<std::size_t>(row)),
                                kZRollPitch.at(static_cast<std::size_t>(column)));
      if (!std::isfinite(value) || (row == column && value < 0)) return std::nullopt;
      isKnown |= value != 0;
      out(row, column) = value;
    }
  if (!isKnown) return std::nullopt;
  return out;
}

bool isCovariance(const mrpt::math::CMatrixDouble66& matrix)
{
  using Matrix = Eigen::Matrix<double, 6, 6>;
  // shares of the deviations, since metres and radians do not compare; texts round small ones to 0
  constexpr double kSmallest = 1e-6, kRounding = 1e-3;
  const Matrix covariance = matrix.asEigen();
  if (!covariance.allFinite() || covariance.diagonal().minCoeff() < 0) return false;
  const double largest = covariance.diagonal().maxCoeff();
  if (largest == 0) return covariance.isZero(0);
  const Eigen::Matrix<double, 6, 1> deviations =
      covariance.diagonal().cwiseMax(kSmallest * largest).cwiseSqrt();
  const Matrix shares =
      deviations.cwiseInverse().asDiagonal() * covariance * deviations.cwiseInverse().asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Matrix>(shares, Eigen::EigenvaluesOnly)
             .eigenvalues()
             .minCoeff() >= -kRounding;
}

}  // namespace mrpt_mapconv::observation
