#include <mrpt_mapconv/eval/LayerErrors.h>

#include <cmath>
#include <limits>

#include "ComparedMaps.h"

namespace mrpt_mapconv::eval
{
using grid::Layer;

std::vector<double> errorsOf(const Layer<float>& map, const Layer<float>& truth,
                             const CellMask& judged)
{
  const auto said = on(truth.frame(), map, std::numeric_limits<float>::quiet_NaN());
  const auto mask = on(truth.frame(), judged, std::uint8_t{0});
  std::vector<double> errors;
  for (std::size_t i = 0; i < truth.cells().size(); ++i)
  {
    const double error =
        static_cast<double>(said.cells()[i]) - static_cast<double>(truth.cells()[i]);
    if (mask.cells()[i] && std::isfinite(error)) errors.push_back(error);
  }
  return errors;
}

Rmse rmse(const Layer<float>& map, const Layer<float>& truth, const CellMask& judged)
{
  double sum = 0;
  const auto errors = errorsOf(map, truth, judged);
  for (const double error : errors) sum += error * error;
  return {std::sqrt(sum / static_cast<double>(errors.size())), errors.size()};
}

}  // namespace mrpt_mapconv::eval
