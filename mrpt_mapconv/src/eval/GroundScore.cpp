#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/eval/GroundScore.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "ComparedMaps.h"

namespace mrpt_mapconv::eval
{
double GroundScore::typeI() const { return share(groundAsOther, groundAsGround + groundAsOther); }

double GroundScore::typeII() const { return share(otherAsGround, otherAsGround + otherAsOther); }

double GroundScore::total() const
{
  return share(groundAsOther + otherAsGround,
               groundAsGround + groundAsOther + otherAsGround + otherAsOther);
}

double GroundScore::kappa() const
{
  const std::size_t all = groundAsGround + groundAsOther + otherAsGround + otherAsOther;
  const double trueGround = share(groundAsGround + groundAsOther, all);
  const double foundGround = share(groundAsGround + otherAsGround, all);
  const double byChance = trueGround * foundGround + (1 - trueGround) * (1 - foundGround);
  if (byChance == 1) return std::numeric_limits<double>::quiet_NaN();
  return (1 - total() - byChance) / (1 - byChance);
}

GroundScore scoreGround(const std::vector<std::uint8_t>& found,
                        const std::vector<std::uint8_t>& truth)
{
  if (found.size() != truth.size())
    throw std::invalid_argument("classes of " + std::to_string(found.size()) +
                                " points cannot be compared with those of " +
                                std::to_string(truth.size()));
  GroundScore score;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const bool isFound = found[i] == cloud::kGround;
    if (truth[i] == cloud::kGround)
      ++(isFound ? score.groundAsGround : score.groundAsOther);
    else
      ++(isFound ? score.otherAsGround : score.otherAsOther);
  }
  return score;
}

}  // namespace mrpt_mapconv::eval
