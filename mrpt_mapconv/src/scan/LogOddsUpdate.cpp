#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "BitRow.h"

namespace mrpt_mapconv::scan
{
using params::require;

namespace
{
constexpr double kUnits = 16;       // of MRPT's cells, per natural unit of log-odds
constexpr double kMostUnits = 127;  // in a cell, either way
constexpr double kSlack = 1e-9;     // so that a probability made of whole units gives these

/** Made only for a message: each scan checks its parameters, and is to need no memory. */
std::string beside(const char* right, double value, const char* why)
{
  return std::string(right) + " = " + params::shortestText(value) + ": " + why;
}

double unitsOf(double p) { return kUnits * std::log(p / (1 - p)); }

/** Calls visit(cell) for the cells of a word of a row.
 * \param begin index of the row's first column in the grid, which may lie outside of it */
template <class Visit>
void forEachCell(std::uint64_t bits, std::int32_t word, std::int64_t begin, std::int8_t* cells,
                 const Visit& visit)
{
  if (bits == ~std::uint64_t(0))
  {
    std::int8_t* first = cells + begin + 64 * word;
    for (int i = 0; i < 64; ++i) first[i] = visit(first[i]);
    return;
  }
  forEachBit(bits, word,
             [&](std::int32_t column) { cells[begin + column] = visit(cells[begin + column]); });
}
}  // namespace

void UpdateParams::check() const
{
  require(pHit > 0.5 && pHit < 1, "pHit", pHit, "above 0.5 and below 1");
  require(pMiss > 0 && pMiss < 0.5, "pMiss", pMiss, "above 0 and below 0.5");
  require(pMin > 0 && pMin < 0.5, "pMin", pMin, "above 0 and below 0.5");
  require(pMax > 0.5 && pMax < 1, "pMax", pMax, "above 0.5 and below 1");
  // below that MRPT's cells, which are coarse, would not change at all
  require(std::lround(unitsOf(pHit)) > 0, "pHit", pHit, "at least 0.508");
  require(std::lround(unitsOf(pMiss)) < 0, "pMiss", pMiss, "at most 0.492");
  require(unitsOf(pMax) >= 1, "pMax", pMax, "at least 0.516");
  require(unitsOf(pMin) <= -1, "pMin", pMin, "at most 0.484");
  if (pHit > pMax)
    require(false, "pHit", pHit, beside("at most pMax", pMax, "no cell can be more probable"));
  if (pMiss < pMin)
    require(false, "pMiss", pMiss, beside("at least pMin", pMin, "no cell can be less probable"));
}

LogOddsUpdate::LogOddsUpdate(const UpdateParams& params)
{
  params.check();
  // cells count what speaks for free
  const auto units = [](double value) { return static_cast<int>(std::min(value, kMostUnits)); };
  m_hit = static_cast<int>(std::lround(std::min(unitsOf(params.pHit), 2 * kMostUnits)));
  m_miss = static_cast<int>(std::lround(std::min(-unitsOf(params.pMiss), 2 * kMostUnits)));
  m_lowest = -units(std::floor(unitsOf(params.pMax) + kSlack));
  m_highest = units(std::floor(-unitsOf(params.pMin) + kSlack));
}

void LogOddsUpdate::apply(const ScanProfile& profile, const grid::GridFrame& frame,
                          std::int8_t* cells) const
{
  const grid::GridFrame bounds = profile.bounds();
  if (bounds.empty()) return;
  if (bounds.resolution != frame.resolution || !frame.containsKey(bounds.x0, bounds.y0) ||
      !frame.containsKey(bounds.xEnd() - 1, bounds.yEnd() - 1))
    throw std::invalid_argument("log-odds update: the grid does not hold the scan's cells");

  const auto hit = [this](int cell)
  { return static_cast<std::int8_t>(std::min(cell, std::max(cell - m_hit, m_lowest))); };
  const auto miss = [this](int cell)
  { return static_cast<std::int8_t>(std::max(cell, std::min(cell + m_miss, m_highest))); };
  const grid::GridFrame& square = profile.occupied().frame();
  for (std::int32_t ky = bounds.y0; ky < bounds.yEnd(); ++ky)
  {
    const std::uint64_t* occupied = profile.occupied().row(ky - square.y0);
    const std::uint64_t* free = profile.free().row(ky - square.y0);
    const std::int64_t begin = std::int64_t(ky - frame.y0) * frame.width + (square.x0 - frame.x0);
    forEachWord(bounds.x0 - square.x0, bounds.xEnd() - 1 - square.x0,
                [&](std::int32_t word, std::uint64_t)
                {
                  forEachCell(occupied[word], word, begin, cells, hit);
                  forEachCell(free[word], word, begin, cells, miss);
                });
  }
}

}  // namespace mrpt_mapconv::scan
