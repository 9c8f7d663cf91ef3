#pragma once

#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <octomap/octomap.h>

#include "../oracle/DenseMap.h"
#include "RandomMap.h"

namespace mrpt_mapconv::test
{
/** A box of voxels, counted from the first voxel of the editor's world; ends are not included. */
struct EditBox
{
  int x = 0, y = 0, z = 0;
  int xEnd = 0, yEnd = 0, zEnd = 0;
};

/** An OctoMap that is edited at random while a plain array keeps track of what it must hold.
 *
 * Every edit also names the columns that it touched. */
class MapEditor
{
 public:
  static constexpr int kSide = 100, kHeight = 40;  //!< size of the world in voxels

  /** A world whose first voxel has the given key, with a patch of ground in its middle. */
  MapEditor(Rng& rng, double resolution, int x0, int y0, int z0);

  const octomap::OcTree& tree() const { return m_tree; }
  /** One random edit; returns the touched columns. */
  voxel::ColumnSet edit();
  const char* lastEdit() const { return m_lastEdit; }

 private:
  EditBox knownBox() const;  //!< bounding box of what is known; all 0 if nothing is
  int near(int begin, int end) { return pick(m_rng, begin - 1, end); }
  EditBox smallBox(int side, int height);
  void set(const EditBox& box, oracle::Voxel state);
  void setVoxels();
  void setColumns();
  void setCube();
  void flip();
  void erase(const EditBox& box);
  void eraseAnEdge();
  void grow();
  void clear();
  void rebuildTree();
  void touch(int ix, int iy) { m_touched.insert(m_map.x0 + ix, m_map.y0 + iy); }
  octomap::OcTreeKey keyOf(int ix, int iy, int iz) const
  {
    return oracle::octomapKey(m_map.x0 + ix, m_map.y0 + iy, m_map.z0 + iz);
  }

  Rng& m_rng;
  octomap::OcTree m_tree;
  oracle::DenseMap m_map;
  voxel::ColumnSet m_touched;
  const char* m_lastEdit = "";
};

}  // namespace mrpt_mapconv::test
