#pragma once

#include <mrpt_mapconv/params/Fields.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mrpt_mapconv::voxel
{
/** What unknown voxels are taken for. */
enum class Unknown : std::uint8_t
{
  Unknown,
  Free  //!< those above occupied ones, see FilledSource
};

/** How files call them, in the order of the enumeration. */
inline const std::vector<std::string>& namesOf(Unknown)
{
  static const std::vector<std::string> names{"unknown", "free"};
  return names;
}

/** How a voxel map is read. */
struct ReadingParams
{
  Unknown unknown = Unknown::Unknown;

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    v("unknown", p.unknown, "",
      "what unknown voxels above a column's lowest occupied one are taken for: unknown or free; "
      "free is for maps made of clouds or meshes, which know of no free space",
      params::flag("STATE").since(1));
  }
  /** Every value is good. */
  void check() const {}
};

/** A voxel map with its unknown voxels taken for what ReadingParams says.
 *
 * Unknown::Free: in columns with an occupied voxel, unknown voxels above the lowest of them, up to
 * the height of the map's highest known voxel, are free. Other columns stay as they are.
 *
 * The source must outlive this; once it has changed, another FilledSource has to be made of it. */
class FilledSource : public VoxelSource
{
 public:
  FilledSource(const VoxelSource& source, const ReadingParams& params);
  double resolution() const override { return m_source.resolution(); }
  std::optional<KeyRect> bounds() const override { return m_source.bounds(); }
  void read(ColumnBlock& block) const override;
  std::optional<std::int32_t> top() const override { return m_source.top(); }

  /** z key up to which voxels are free; nothing if unknown ones stay unknown. */
  std::optional<std::int32_t> freeUpTo() const { return m_freeUpTo; }

 private:
  const VoxelSource& m_source;
  std::optional<std::int32_t> m_freeUpTo;
};

}  // namespace mrpt_mapconv::voxel
