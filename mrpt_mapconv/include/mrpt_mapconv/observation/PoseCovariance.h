#pragma once

#include <mrpt/math/CMatrixFixed.h>

#include <optional>

namespace mrpt_mapconv::observation
{
/** Covariance of a robot's z [m], roll and pitch [rad], in this order: what the heights of the
 * points that it sees are uncertain by. */
using HeightCovariance = mrpt::math::CMatrixDouble33;

/** That part of a pose's covariance, whose order is MRPT's: x, y, z, yaw, pitch, roll. Nothing if
 * it is all 0, which is how MRPT writes that nobody knows, or none (not finite, a variance < 0). */
std::optional<HeightCovariance> heightCovariance(const mrpt::math::CMatrixDouble66& pose);

/** Whether a matrix can be a covariance: finite, no variance < 0, positive semi-definite but for
 * the rounding of numbers in texts. */
bool isCovariance(const mrpt::math::CMatrixDouble66& matrix);

}  // namespace mrpt_mapconv::observation
