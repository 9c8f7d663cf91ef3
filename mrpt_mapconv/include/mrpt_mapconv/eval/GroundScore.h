#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrpt_mapconv::eval
{
/** How many points of a cloud are classified as they are in truth, as Sithole and Vosselman (2004)
 * count them. */
struct GroundScore
{
  std::size_t groundAsGround = 0, groundAsOther = 0;
  std::size_t otherAsGround = 0, otherAsOther = 0;

  double typeI() const;   //!< of the true ground points, the share that was missed; NaN of none
  double typeII() const;  //!< of the other points, the share taken for ground; NaN of none
  double total() const;   //!< share of all points that are wrong; NaN of none
  double kappa() const;   //!< Cohen's: 1 all right, 0 as by chance; NaN if chance is always right
};

/** \param found,truth classes of the same points; those of cloud::kGround are ground, all others
 * are not
 * \exception std::invalid_argument for different numbers of points */
GroundScore scoreGround(const std::vector<std::uint8_t>& found,
                        const std::vector<std::uint8_t>& truth);

}  // namespace mrpt_mapconv::eval
