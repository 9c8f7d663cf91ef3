#include "MapEditor.h"

#include <algorithm>

namespace mrpt_mapconv::test
{
using oracle::Voxel;

namespace
{
Voxel randomState(Rng& rng) { return chance(rng, 65) ? Voxel::Free : Voxel::Occupied; }

template <class Visit>
void forEachVoxel(const EditBox& box, const Visit& visit)
{
  for (int iy = std::max(0, box.y); iy < std::min(MapEditor::kSide, box.yEnd); ++iy)
    for (int ix = std::max(0, box.x); ix < std::min(MapEditor::kSide, box.xEnd); ++ix)
      for (int iz = std::max(0, box.z); iz < std::min(MapEditor::kHeight, box.zEnd); ++iz)
        visit(ix, iy, iz);
}

}  // namespace

MapEditor::MapEditor(Rng& rng, double resolution, int x0, int y0, int z0)
    : m_rng(rng), m_tree(resolution)
{
  m_map.resolution = resolution;
  m_map.x0 = x0, m_map.y0 = y0, m_map.z0 = z0;
  m_map.nx = m_map.ny = kSide, m_map.nz = kHeight;
  m_map.voxels.assign(std::size_t{kSide} * kSide * kHeight, Voxel::Unknown);
  const int x = kSide / 2, y = kSide / 2, size = pick(rng, 1, 12);
  for (int iy = y; iy < y + size; ++iy)
    for (int ix = x; ix < x + size; ++ix)
    {
      const int ground = 8 + pick(rng, 0, 2);
      set({ix, iy, ground, ix + 1, iy + 1, ground + 1}, Voxel::Occupied);
      set({ix, iy, ground + 1, ix + 1, iy + 1, ground + 15}, Voxel::Free);
    }
}

voxel::ColumnSet MapEditor::edit()
{
  m_touched.clear();
  const int dice = pick(m_rng, 1, 100);
  if (dice <= 25)
    setVoxels();
  else if (dice <= 45)
    setColumns();
  else if (dice <= 55)
    setCube();
  else if (dice <= 65)
    flip();
  else if (dice <= 75)
    m_lastEdit = "erase a box", erase(smallBox(8, kHeight));
  else if (dice <= 81)
    eraseAnEdge();
  else if (dice <= 95)
    grow();
  else if (dice <= 98)
    m_lastEdit = "nothing";
  else
    clear();
  return m_touched;
}

EditBox MapEditor::knownBox() const
{
  EditBox box{kSide, kSide, kHeight, 0, 0, 0};
  forEachVoxel({0, 0, 0, kSide, kSide, kHeight},
               [&](int ix, int iy, int iz)
               {
                 if (m_map.at(ix, iy, iz) == Voxel::Unknown) return;
                 box.x = std::min(box.x, ix), box.xEnd = std::max(box.xEnd, ix + 1);
                 box.y = std::min(box.y, iy), box.yEnd = std::max(box.yEnd, iy + 1);
                 box.z = std::min(box.z, iz), box.zEnd = std::max(box.zEnd, iz + 1);
               });
  return box.xEnd == 0 ? EditBox{} : box;
}

EditBox MapEditor::smallBox(int side, int height)
{
  const EditBox known = knownBox();
  const int x = near(known.x, known.xEnd), y = near(known.y, known.yEnd);
  const int z = pick(m_rng, 0, kHeight - 1);
  return {x, y, z, x + pick(m_rng, 1, side), y + pick(m_rng, 1, side), z + pick(m_rng, 1, height)};
}

void MapEditor::set(const EditBox& box, Voxel state)
{
  forEachVoxel(box,
               [&](int ix, int iy, int iz)
               {
                 m_map.at(ix, iy, iz) = state;
                 touch(ix, iy);
                 m_tree.setNodeValue(keyOf(ix, iy, iz), state == Voxel::Free ? -0.4f : 0.85f);
               });
}

void MapEditor::setVoxels()
{
  m_lastEdit = "single voxels";
  for (int i = pick(m_rng, 1, 20); i > 0; --i) set(smallBox(1, 1), randomState(m_rng));
}

void MapEditor::setColumns()
{
  m_lastEdit = "column runs";
  for (int i = pick(m_rng, 1, 5); i > 0; --i) set(smallBox(1, 20), randomState(m_rng));
}

void MapEditor::setCube()
{
  m_lastEdit = "an aligned cube";  // becomes one coarse leaf
  const int side = 1 << pick(m_rng, 1, 4);
  const EditBox near = smallBox(1, 1);
  const int x = near.x - ((near.x + m_map.x0) & (side - 1));
  const int y = near.y - ((near.y + m_map.y0) & (side - 1));
  const int z = near.z - ((near.z + m_map.z0) & (side - 1));
  set({x, y, z, x + side, y + side, z + side}, randomState(m_rng));
}

void MapEditor::flip()
{
  m_lastEdit = "free and occupied swapped";
  forEachVoxel(smallBox(6, kHeight),
               [&](int ix, int iy, int iz)
               {
                 const Voxel state = m_map.at(ix, iy, iz);
                 if (state != Voxel::Unknown)
                   set({ix, iy, iz, ix + 1, iy + 1, iz + 1},
                       state == Voxel::Free ? Voxel::Occupied : Voxel::Free);
               });
}

void MapEditor::erase(const EditBox& box)
{
  bool someLeft = false;
  forEachVoxel(box,
               [&](int ix, int iy, int iz)
               {
                 if (m_map.at(ix, iy, iz) == Voxel::Unknown) return;
                 m_map.at(ix, iy, iz) = Voxel::Unknown;
                 touch(ix, iy);
                 deleteVoxel(m_tree, keyOf(ix, iy, iz));
                 someLeft = someLeft || m_tree.search(keyOf(ix, iy, iz)) != nullptr;
               });
  if (someLeft) rebuildTree();  // OctoMap cannot delete a node's last child
}

void MapEditor::eraseAnEdge()
{
  m_lastEdit = "erase an edge of the map";
  EditBox box = knownBox();
  const int width = pick(m_rng, 1, 6);
  switch (pick(m_rng, 0, 3))
  {
    case 0:
      box.xEnd = std::min(box.xEnd, box.x + width);
      break;
    case 1:
      box.x = std::max(box.x, box.xEnd - width);
      break;
    case 2:
      box.yEnd = std::min(box.yEnd, box.y + width);
      break;
    default:
      box.y = std::max(box.y, box.yEnd - width);
      break;
  }
  erase(box);
}

void MapEditor::grow()
{
  m_lastEdit = "grow";
  const EditBox known = knownBox();
  const int away = chance(m_rng, 70) ? 1 : pick(m_rng, 1, 25);
  int x = near(known.x, known.xEnd), y = near(known.y, known.yEnd);
  switch (pick(m_rng, 0, 3))
  {
    case 0:
      x = known.x - away;
      break;
    case 1:
      x = known.xEnd - 1 + away;
      break;
    case 2:
      y = known.y - away;
      break;
    default:
      y = known.yEnd - 1 + away;
      break;
  }
  const int z = pick(m_rng, 0, 20), side = pick(m_rng, 1, 4);
  set({x, y, z, x + side, y + side, z + pick(m_rng, 1, 18)}, randomState(m_rng));
}

void MapEditor::clear()
{
  m_lastEdit = "clear";
  forEachVoxel({0, 0, 0, kSide, kSide, kHeight},
               [&](int ix, int iy, int iz)
               {
                 if (m_map.at(ix, iy, iz) != Voxel::Unknown) touch(ix, iy);
                 m_map.at(ix, iy, iz) = Voxel::Unknown;
               });
  m_tree.clear();
}

void MapEditor::rebuildTree()
{
  m_tree.clear();
  fillTree(m_rng, m_map, false, m_tree);
  m_tree.updateInnerOccupancy();
  m_tree.prune();
}

}  // namespace mrpt_mapconv::test
