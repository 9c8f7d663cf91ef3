// Inferred ground that follows a changing map against converting the whole map anew.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>

#include <algorithm>
#include <string>

#include "CompareLayers.h"
#include "DenseSource.h"
#include "FailingSource.h"
#include "RandomGround.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using freespace::IncrementalLayers;
using oracle::DenseMap;
using oracle::Voxel;

/** Changes columns of a map, and tells which. */
class GroundEditor
{
 public:
  GroundEditor(Rng& rng, DenseMap& map) : m_rng(rng), m_map(map) {}

  voxel::ColumnSet edit()
  {
    m_changed.clear();
    const int dice = pick(m_rng, 1, 100);
    if (dice <= 30)  // single columns
      for (int i = pick(m_rng, 1, 6); i > 0; --i) remake(box(1, 1));
    else if (dice <= 50)  // a line, across gaps perhaps
      remake(chance(m_rng, 50) ? box(40, 1) : box(1, 40));
    else if (dice <= 65)
      remake(box(9, 9));
    else if (dice <= 80)  // what was open is seen, or the other way round
      swapGround(chance(m_rng, 50) ? box(3, 3) : box(25, 2));
    else if (dice <= 90)
      hide(box(6, 6));
    else
      raiseFree(box(12, 12));
    return m_changed;
  }

 private:
  struct Box
  {
    int x, y, xEnd, yEnd;
  };

  Box box(int width, int height)
  {
    const int x = pick(m_rng, 0, m_map.nx - 1), y = pick(m_rng, 0, m_map.ny - 1);
    return {x, y, std::min(m_map.nx, x + pick(m_rng, 1, width)),
            std::min(m_map.ny, y + pick(m_rng, 1, height))};
  }

  template <class Visit>
  void forEach(const Box& box, const Visit& visit)
  {
    for (int iy = box.y; iy < box.yEnd; ++iy)
      for (int ix = box.x; ix < box.xEnd; ++ix)
      {
        visit(ix, iy);
        m_changed.insert(m_map.x0 + ix, m_map.y0 + iy);
      }
  }

  void remake(const Box& box)
  {
    const auto kind = static_cast<ColumnKind>(pick(m_rng, 0, 3));
    const int floor = pick(m_rng, 14, 22);
    forEach(box, [&](int ix, int iy)
            { setColumn(m_rng, m_map, ix, iy, kind, floor + pick(m_rng, 0, 1)); });
  }

  /** Something stands under the floor, or no longer, while the floor stays. */
  void hide(const Box& box)
  {
    const Voxel kind = chance(m_rng, 70) ? Voxel::Occupied : Voxel::Unknown;
    const int depth = pick(m_rng, 2, 5);
    forEach(box,
            [&](int ix, int iy)
            {
              const int iz = lowestFree(ix, iy) - depth;
              if (iz >= 0 && iz + depth < m_map.nz) m_map.at(ix, iy, iz) = kind;
            });
  }

  int lowestFree(int ix, int iy) const
  {
    int iz = 0;
    while (iz < m_map.nz && m_map.at(ix, iy, iz) != Voxel::Free) ++iz;
    return iz;
  }

  void swapGround(const Box& box)
  {
    forEach(box,
            [&](int ix, int iy)
            {
              const int floor = lowestFree(ix, iy);
              if (floor == 0 || floor == m_map.nz) return;
              Voxel& under = m_map.at(ix, iy, floor - 1);
              under = under == Voxel::Occupied ? Voxel::Unknown : Voxel::Occupied;
            });
  }

  void raiseFree(const Box& box)
  {
    const bool up = chance(m_rng, 50);
    forEach(box,
            [&](int ix, int iy)
            {
              const int floor = lowestFree(ix, iy);
              if (floor < 2 || floor == m_map.nz) return;
              m_map.at(ix, iy, up ? floor : floor - 1) = up ? Voxel::Unknown : Voxel::Free;
            });
  }

  Rng& m_rng;
  DenseMap& m_map;
  voxel::ColumnSet m_changed;
};

/** Leaves a part of a map, so that it grows to all sides when the rest is edited. */
void forgetAllBut(Rng& rng, DenseMap& map)
{
  const int x = pick(rng, 0, map.nx - 1), y = pick(rng, 0, map.ny - 1);
  const int xEnd = pick(rng, x + 1, map.nx), yEnd = pick(rng, y + 1, map.ny);
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      if (ix < x || iy < y || ix >= xEnd || iy >= yEnd)
        setColumn(rng, map, ix, iy, ColumnKind::None, 0);
}

void expectOnlySaidOnesChanged(const freespace::Layers& before, const freespace::Layers& after,
                               const voxel::ColumnSet& said)
{
  freespace::Layers others = after;
  said.clipped(before.frame())
      .forEach(
          [&](std::int32_t kx, std::int32_t ky)
          {
            const std::size_t i = before.frame().indexOfKey(kx, ky);
            for (const auto& entry : freespace::Layers::list())
              (others.*entry.member).cells()[i] = (before.*entry.member).cells()[i];
          });
  EXPECT_TRUE(sameBits(others, before));
}

TEST(EvidenceIncremental, RandomEditsEqualFullConversions)
{
  constexpr double kResolutions[] = {0.05, 0.1, 0.2, 0.3, 1.0};
  for (unsigned seed = 1; seed <= 500 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    DenseMap map = randomGround(rng, kResolutions[seed % 5]);
    const DenseSource source(map);
    const freespace::ConversionParams params = randomGroundParams(rng, map.resolution);
    if (chance(rng, 30)) forgetAllBut(rng, map);
    IncrementalLayers followed(params, pick(rng, 1, 3));
    followed.rebuild(source);
    GroundEditor editor(rng, map);
    for (int step = 1; step <= 25 && !HasFailure(); ++step)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step) + "; " +
                   text(params));
      const voxel::ColumnSet changed = editor.edit();
      if (chance(rng, 10)) followed = IncrementalLayers(followed);  // a copy goes on as well
      const freespace::Layers before = followed.layers();
      const freespace::LayersChange change = followed.update(source, changed);
      if (!source.bounds()) break;
      const freespace::Layers full = freespace::convert(source, params, 1);
      EXPECT_TRUE(isPaddedWith(followed.layers(), full));
      EXPECT_TRUE(sameBits(followed.exact(source), full));
      if (!change.everywhere) expectOnlySaidOnesChanged(before, followed.layers(), change.columns);
    }
  }
}

TEST(EvidenceIncremental, ARebuildThatFailsChangesNothing)
{
  int failures = 0;
  for (unsigned seed = 1; seed <= 500 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    DenseMap map = randomGround(rng, 0.1);
    const DenseSource source(map);
    FailingSource failing(source);
    IncrementalLayers followed(randomGroundParams(rng, map.resolution), 1);
    followed.rebuild(failing);
    const voxel::ColumnSet changed = GroundEditor(rng, map).edit();
    failures += failing.failsIn(pick(rng, 0, 2), [&] { followed.rebuild(failing); });
    followed.update(failing, changed);
    if (!source.bounds()) continue;
    EXPECT_TRUE(sameBits(followed.exact(source), freespace::convert(source, followed.params(), 1)));
  }
  EXPECT_GT(failures, 100);
}

}  // namespace
