#include "CompareLayers.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>

namespace mrpt_mapconv::test
{
using freespace::Layers;
using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

namespace
{
std::uint32_t bitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

bool sameBits(float a, float b) { return bitsOf(a) == bitsOf(b); }

/** Equal to the bit; all NaNs are alike. */
bool sameHeight(float a, float b) { return (std::isnan(a) && std::isnan(b)) || sameBits(a, b); }

bool withinOneFloat(float value, double expected)
{
  const auto nearest = static_cast<float>(expected);
  return value == nearest || value == std::nextafter(nearest, 2.0f) ||
         value == std::nextafter(nearest, -2.0f);
}

bool sameOccupancy(float value, double expected)
{
  // free and unknown have one value each; only a share is rounded
  return expected > 0 ? value > 0 && withinOneFloat(value, expected)
                      : value == static_cast<float>(expected);
}

bool sameSlope(float value, const oracle::Cell& cell)
{
  if (!cell.hasSlope) return std::isnan(value);
  const auto expected = static_cast<double>(cell.slope);
  return expected == 0 ? value == 0 : std::abs(value - expected) <= 1e-6 * expected;
}

bool sameGround(float value, const oracle::Cell& cell)
{
  const bool tie = cell.free && cell.hasSlope && cell.slopeTie && !cell.isStep && !cell.isDrop;
  return tie ? value == 0 || value == 1 : sameOccupancy(value, cell.ground);
}

std::string describe(const Layers& layers, int ix, int iy, const oracle::Cell& cell)
{
  std::ostringstream out;
  out.precision(17);
  out << "cell (" << ix << ", " << iy << "), key (" << layers.frame().x0 + ix << ", "
      << layers.frame().y0 + iy << ")";
  for (const auto& [name, layer] : layers.named())
    out << "\n  " << name << " " << layer->at(ix, iy);
  out << "\nexpected\n  floor " << cell.floor << "\n  ceiling " << cell.ceiling << "\n  slope "
      << (cell.hasSlope ? cell.slope : std::numeric_limits<long double>::quiet_NaN())
      << (cell.slopeTie ? " (tie)" : "") << "\n  aerial " << cell.aerial << "\n  ground "
      << cell.ground << (cell.isStep ? " (step)" : "") << (cell.isDrop ? " (drop)" : "")
      << "\n  support " << cell.support << "\n  evidence " << static_cast<int>(cell.evidence);
  return out.str();
}

AssertionResult sameFrame(const grid::GridFrame& frame, const oracle::DenseMap& map)
{
  if (frame.x0 == map.x0 && frame.y0 == map.y0 && frame.width == map.nx && frame.height == map.ny &&
      frame.resolution == map.resolution)
    return AssertionSuccess();
  return AssertionFailure() << "frame at (" << frame.x0 << ", " << frame.y0 << "), size "
                            << frame.width << "x" << frame.height << ", resolution "
                            << frame.resolution << "; expected (" << map.x0 << ", " << map.y0
                            << "), " << map.nx << "x" << map.ny << ", " << map.resolution;
}

}  // namespace

AssertionResult agreesWithOracle(const Layers& layers, const oracle::DenseMap& map,
                                 const oracle::DenseResult& expected)
{
  for (const auto& [name, layer] : layers.named())
    if (const AssertionResult frame = sameFrame(layer->frame(), map); !frame)
      return AssertionFailure() << name << ": " << frame.message();

  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      const oracle::Cell& cell = expected.at(ix, iy);
      if (!sameHeight(layers.floor.at(ix, iy), cell.floor) ||
          !sameHeight(layers.ceiling.at(ix, iy), cell.ceiling) ||
          !sameSlope(layers.slope.at(ix, iy), cell) ||
          !sameOccupancy(layers.aerial.at(ix, iy), cell.aerial) ||
          !sameGround(layers.ground.at(ix, iy), cell) ||
          !sameHeight(layers.support.at(ix, iy), cell.support) ||
          layers.evidence.at(ix, iy) != static_cast<float>(cell.evidence))
        return AssertionFailure() << describe(layers, ix, iy, cell);
    }
  return AssertionSuccess();
}

AssertionResult countsAgree(const freespace::LayerStatistics& counts,
                            const oracle::DenseResult& expected)
{
  const oracle::DenseStatistics wanted = oracle::statistics(expected);
  std::size_t ties = 0;
  for (const oracle::Cell& cell : expected.cells) ties += cell.free && cell.slopeTie ? 1 : 0;
  const std::size_t steepError =
      counts.steep > wanted.steep ? counts.steep - wanted.steep : wanted.steep - counts.steep;
  if (counts.free == wanted.free && counts.occupied == wanted.occupied &&
      counts.unknown == wanted.unknown && counts.slopeUnknown == wanted.slopeUnknown &&
      counts.frontier == wanted.frontier && counts.inferred == wanted.inferred &&
      steepError <= ties)
    return AssertionSuccess();
  return AssertionFailure() << "free " << counts.free << ", occupied " << counts.occupied
                            << ", unknown " << counts.unknown << ", steep " << counts.steep
                            << ", slopeUnknown " << counts.slopeUnknown << ", frontier "
                            << counts.frontier << ", inferred " << counts.inferred << "; expected "
                            << wanted.free << ", " << wanted.occupied << ", " << wanted.unknown
                            << ", " << wanted.steep << " +- " << ties << ", " << wanted.slopeUnknown
                            << ", " << wanted.frontier << ", " << wanted.inferred;
}

AssertionResult sameBits(const Layers& a, const Layers& b)
{
  const auto namedA = a.named(), namedB = b.named();
  for (std::size_t i = 0; i < namedA.size(); ++i)
  {
    const auto &layerA = *namedA[i].second, &layerB = *namedB[i].second;
    if (layerA.frame() != layerB.frame() || layerA.cells().size() != layerB.cells().size())
      return AssertionFailure() << namedA[i].first << ": frames differ";
    for (std::size_t c = 0; c < layerA.cells().size(); ++c)
      if (!sameBits(layerA.cells()[c], layerB.cells()[c]))
        return AssertionFailure() << namedA[i].first << " at cell " << c << " of width "
                                  << layerA.frame().width << ": " << layerA.cells()[c] << " versus "
                                  << layerB.cells()[c];
  }
  return AssertionSuccess();
}

AssertionResult isPaddedWith(const Layers& wide, const Layers& exact)
{
  const Layers unknown(grid::GridFrame{exact.frame().resolution, 0, 0, 1, 1});
  const auto wideNamed = wide.named(), exactNamed = exact.named(), unknownNamed = unknown.named();
  const grid::GridFrame &outer = wide.frame(), &inner = exact.frame();
  if (!inner.empty() && (!outer.containsKey(inner.x0, inner.y0) ||
                         !outer.containsKey(inner.xEnd() - 1, inner.yEnd() - 1)))
    return AssertionFailure() << "the frame does not hold the whole map";
  for (std::size_t i = 0; i < wideNamed.size(); ++i)
    for (std::int32_t ky = outer.y0; ky < outer.yEnd(); ++ky)
      for (std::int32_t kx = outer.x0; kx < outer.xEnd(); ++kx)
      {
        const float expected = inner.containsKey(kx, ky)
                                   ? exactNamed[i].second->cells()[inner.indexOfKey(kx, ky)]
                                   : unknownNamed[i].second->at(0, 0);
        const float value = wideNamed[i].second->cells()[outer.indexOfKey(kx, ky)];
        if (!sameBits(value, expected))
          return AssertionFailure() << wideNamed[i].first << " at key (" << kx << ", " << ky
                                    << "): " << value << ", expected " << expected;
      }
  return AssertionSuccess();
}

std::string text(const freespace::ConversionParams& params)
{
  std::ostringstream out;
  out.precision(17);
  out << "minClearance " << params.minClearance << ", minOccupancy " << params.minOccupancy
      << ", slopeWindow " << params.slopeWindow << ", maxSlope " << params.maxSlope << ", maxStep "
      << params::textOf(params.maxStep) << ", unknown " << params::textOf(params.reading.unknown)
      << ", floorFrom " << params::textOf(params.floorFrom) << ", maxGap " << params.maxGap
      << ", maxHiddenGap " << params.maxHiddenGap;
  return out.str();
}

}  // namespace mrpt_mapconv::test
