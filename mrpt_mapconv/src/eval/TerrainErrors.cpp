#include <mrpt_mapconv/eval/TerrainErrors.h>
#include <mrpt_mapconv/terrain/PlaneFit.h>

#include "ComparedMaps.h"

namespace mrpt_mapconv::eval
{
using grid::Layer;

namespace
{
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
}

ErrorSummary summaryOf(const std::vector<double>& errors)
{
  if (errors.empty()) return {};
  double sum = 0, absolute = 0, squares = 0;
  for (const double error : errors)
  {
    sum += error;
    absolute += std::abs(error);
    squares += error * error;
  }
  const auto n = static_cast<double>(errors.size());
  return {errors.size(), sum / n, absolute / n, std::sqrt(squares / n)};
}

std::vector<ErrorSummary> errorsOfPlanes(const Layer<float>& map, const TerrainTruth& truth,
                                         const CellMask& judged)
{
  const auto said = on(truth.height.frame(), map, kNaN);
  const auto mask = on(truth.height.frame(), judged, std::uint8_t{0});
  std::vector<std::vector<double>> errors(truth.planes.size());
  for (std::size_t i = 0; i < said.cells().size(); ++i)
  {
    const std::int32_t plane = truth.plane.cells()[i];
    const double error =
        static_cast<double>(said.cells()[i]) - static_cast<double>(truth.height.cells()[i]);
    if (plane >= 0 && mask.cells()[i] && std::isfinite(error))
      errors[static_cast<std::size_t>(plane)].push_back(error);
  }
  std::vector<ErrorSummary> summaries;
  summaries.reserve(errors.size());
  for (const auto& ofPlane : errors) summaries.push_back(summaryOf(ofPlane));
  return summaries;
}

ErrorSummary residualsToPlane(const Layer<float>& heights, const CellMask& cells)
{
  const auto known = on(cells.frame(), heights, kNaN);
  const auto forEach = [&](const auto& visit)
  {
    for (std::int32_t y = 0; y < cells.frame().height; ++y)
      for (std::int32_t x = 0; x < cells.frame().width; ++x)
        if (cells.at(x, y) && std::isfinite(known.at(x, y)))
          visit(x, y, static_cast<double>(known.at(x, y)) / terrain::kHeightUnit);
  };
  terrain::PlaneMoments moments;
  forEach([&](std::int32_t x, std::int32_t y, double z)
          { moments.add(x, y, static_cast<std::int32_t>(std::lround(z))); });
  if (!moments.spans()) return {};
  const terrain::Plane plane = moments.fit();
  std::vector<double> residuals;
  forEach([&](std::int32_t x, std::int32_t y, double z)
          { residuals.push_back((z - plane.at(x, y)) * terrain::kHeightUnit); });
  return summaryOf(residuals);
}

}  // namespace mrpt_mapconv::eval
