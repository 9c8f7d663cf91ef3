#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/grid/GrownFrame.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "../grid/Parallel.h"
#include "AerialPass.h"
#include "GroundPass.h"
#include "HeightPass.h"
#include "SupportPass.h"

namespace mrpt_mapconv::freespace
{
namespace
{
/** 11 GB of layers; a stray voxel far away should be an error and not fill the memory. */
constexpr std::size_t kMaxCells = 400'000'000;

std::optional<grid::GridFrame> knownFrame(const voxel::VoxelSource& source)
{
  const auto box = source.bounds();
  if (!box) return std::nullopt;
  return voxel::frameOf(*box, source.resolution());
}

/** The blocks of a set from the lowest y up, each row from the lowest x, as cells lie in memory. */
std::vector<voxel::BlockKey> rowByRow(const voxel::ColumnSet::Blocks& blocks)
{
  std::vector<voxel::BlockKey> keys;
  keys.reserve(blocks.size());
  for (const auto& [key, mask] : blocks) keys.push_back(key);
  std::sort(keys.begin(), keys.end(),
            [](const voxel::BlockKey& a, const voxel::BlockKey& b)
            { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
  return keys;
}

using Strip = std::vector<BlockJob>;

/** Jobs for the touched blocks in strips of whole rows of blocks, from the lowest y up: what a
 * strip keeps between the passes is all the memory that a conversion needs beside the layers. */
class Strips
{
 public:
  /** \param reach columns that may depend on those in `changed`
   * \param halo cells around a block that its second pass looks at */
  Strips(const voxel::ColumnSet& changed, const voxel::ColumnSet& reach, std::int32_t halo)
      : m_changed(changed),
        m_reach(reach),
        m_leastRows((halo - 1) / voxel::kBlockSide + 1),
        m_keys(rowByRow(reach.blocks()))
  {
  }

  /** The next strip; empty when there is none left. */
  Strip next()
  {
    constexpr std::size_t leastBlocks = 512;  // enough to share among threads
    Strip strip;
    for (std::int32_t rows = 0; m_next < m_keys.size(); ++m_next)
    {
      const bool newRow = m_next == 0 || m_keys[m_next].y != m_keys[m_next - 1].y;
      if (newRow && strip.size() >= leastBlocks && rows >= m_leastRows) break;
      rows += newRow;
      strip.push_back(job(m_keys[m_next]));
    }
    return strip;
  }

 private:
  BlockJob job(const voxel::BlockKey& key) const
  {
    BlockJob job;
    job.key = key;
    job.reach = m_reach.blocks().at(key);
    if (const auto it = m_changed.blocks().find(key); it != m_changed.blocks().end())
      job.changed = it->second;
    return job;
  }

  const voxel::ColumnSet& m_changed;
  const voxel::ColumnSet& m_reach;
  std::int32_t m_leastRows;  // so that a strip's second pass needs no more than the next strip
  std::vector<voxel::BlockKey> m_keys;
  std::size_t m_next = 0;
};

/** The columns of which a conversion has found that they are not as they were; none of layers that
 * were blank. */
struct Differences
{
  voxel::ColumnSet newGround;        //!< floor, evidence or OpenColumn
  voxel::ColumnSet newAerial;        //!< aerial occupancy
  voxel::ColumnSet::Blocks newSpan;  //!< floor or ceiling, in blocks that are still looked at
};

/** Brings floor, ceiling, aerial occupancy and evidence up to date with the changed columns, of
 * which full conversion is "all". `reach` holds every column that touches them; `blank` says that
 * the layers are all unknown, otherwise they must be what a conversion left before the change. The
 * second pass of a strip runs once the first pass of the next one has found the floors there.
 * \param withGround whether slope and ground occupancy follow at once, while what they need is at
 * hand; that is possible if supports are floors
 */
Differences convertColumns(const voxel::VoxelSource& source, const voxel::ColumnSet& changed,
                           const voxel::ColumnSet& reach, const ConversionParams& params,
                           int threads, Layers& layers, OpenColumns& open, bool blank,
                           bool withGround)
{
  Differences differences;
  const auto findHeights = [&](Strip& strip)
  {
    grid::inParallel(strip.size(), threads,
                     [&](std::size_t begin, std::size_t end)
                     {
                       HeightPass heights(source, params, open, layers, blank);
                       for (std::size_t i = begin; i < end; ++i) heights.run(strip[i]);
                     });
    for (const BlockJob& job : strip)
    {
      open.replace(job.key, job.changed, job.open);
      if (any(job.newGround)) differences.newGround.insert(job.key, job.newGround);
      if (any(job.newSpan)) differences.newSpan.emplace(job.key, job.newSpan);
    }
  };
  const auto findAerial = [&](Strip& strip)
  {
    grid::inParallel(strip.size(), threads,
                     [&](std::size_t begin, std::size_t end)
                     {
                       AerialPass aerial(source, params, differences.newSpan, layers, blank);
                       std::optional<GroundPass> ground;
                       if (withGround) ground.emplace(params, layers);
                       for (std::size_t i = begin; i < end; ++i)
                       {
                         aerial.run(strip[i]);
                         if (ground) ground->run(strip[i].key, strip[i].changed);
                       }
                     });
    for (const BlockJob& job : strip)
      if (any(job.newAerial)) differences.newAerial.insert(job.key, job.newAerial);
  };
  Strips strips(changed, reach, withGround ? GroundPass(params, layers).reach() : 1);
  Strip before, strip = strips.next();
  findHeights(strip);
  while (!strip.empty())
  {
    Strip next = strips.next();
    findHeights(next);
    findAerial(strip);
    for (const BlockJob& job : before) differences.newSpan.erase(job.key);
    before = std::move(strip);
    strip = std::move(next);
  }
  return differences;
}

/** Slope and ground occupancy of columns. */
void findGround(const voxel::ColumnSet& columns, const ConversionParams& params, int threads,
                Layers& layers)
{
  const std::vector<voxel::BlockKey> blocks = rowByRow(columns.blocks());
  grid::inParallel(blocks.size(), threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     GroundPass ground(params, layers);
                     for (std::size_t i = begin; i < end; ++i)
                       ground.run(blocks[i], columns.blocks().at(blocks[i]));
                   });
}

/** Layers, and what an update of them needs beside. */
struct Converted
{
  Layers layers;
  OpenColumns open;
};

Converted convertOn(const grid::GridFrame& frame, const voxel::VoxelSource& source,
                    const ConversionParams& params, int threads)
{
  Converted made{Layers(frame), {}};
  const auto all = voxel::ColumnSet::of(frame);
  const bool floorsSuffice = params.floorFrom == FloorFrom::LowestFree;
  convertColumns(source, all, all, params, threads, made.layers, made.open, true, floorsSuffice);
  if (floorsSuffice) return made;
  SupportPass(params, made.open, made.layers).findAll(threads);
  findGround(all, params, threads, made.layers);
  return made;
}

/** The changed columns without those in which nothing is known and nothing was: a superset of the
 * change does not make the frame grow. */
voxel::ColumnSet changedWithin(const voxel::VoxelSource& source, const voxel::ColumnSet& changed,
                               const grid::GridFrame& frame)
{
  if (unite(frame, changed.bounds(source.resolution())) == frame) return changed;
  const auto known = knownFrame(source);
  return changed.clipped(known ? unite(frame, *known) : frame);
}
}  // namespace

void checkFrameSize(const grid::GridFrame& frame)
{
  if (frame.size() > kMaxCells)
    throw std::runtime_error("the voxel map covers " + std::to_string(frame.width) + " x " +
                             std::to_string(frame.height) + " cells, more than the " +
                             std::to_string(kMaxCells) + " that a 2D map may have");
}

grid::GridFrame grownFrame(const grid::GridFrame& frame, const grid::GridFrame& needed)
{
  const grid::GridFrame least = unite(frame, needed);
  checkFrameSize(least);
  if (frame.empty()) return least;
  return grid::grownFrame(frame, needed, {0.5},
                          [](const grid::GridFrame& roomy) { return roomy.size() <= kMaxCells; });
}

grid::GridFrame frameOf(const voxel::VoxelSource& source)
{
  const auto frame = knownFrame(source);
  if (!frame) throw std::runtime_error("the voxel map is empty: not one voxel is known");
  checkFrameSize(*frame);
  return *frame;
}

Layers convert(const voxel::VoxelSource& source, const ConversionParams& params, int threads)
{
  params.check();
  return convertOn(frameOf(source), voxel::FilledSource(source, params.reading), params, threads)
      .layers;
}

IncrementalLayers::IncrementalLayers(const ConversionParams& params, int threads)
    : m_params(params), m_threads(threads)
{
  m_params.check();
}

Layers IncrementalLayers::exact(const voxel::VoxelSource& source) const
{
  const auto frame = knownFrame(source);
  return frame ? m_layers.onFrame(*frame) : Layers();
}

void IncrementalLayers::rebuild(const voxel::VoxelSource& source)
{
  if (const auto frame = knownFrame(source))
    rebuild(source, *frame);
  else
    clear();
}

void IncrementalLayers::rebuild(const voxel::VoxelSource& source, const grid::GridFrame& frame)
{
  rebuildFilled({source, m_params.reading}, frame);
}

void IncrementalLayers::rebuildFilled(const voxel::FilledSource& source,
                                      const grid::GridFrame& frame)
{
  checkFrameSize(frame);
  Converted made = convertOn(frame, source, m_params, m_threads);
  m_layers = std::move(made.layers);
  m_open = std::move(made.open);
  m_unfinished = false;
  m_freeUpTo = source.freeUpTo();
}

LayersChange IncrementalLayers::update(const voxel::VoxelSource& source,
                                       const voxel::ColumnSet& changed)
{
  const grid::GridFrame old = m_layers.frame();
  const auto inside = changedWithin(source, changed, old);
  if (inside.empty() && !m_unfinished) return {};
  const grid::GridFrame frame = grownFrame(old, inside.bounds(source.resolution()));
  if (frame != old) m_layers = m_layers.onFrame(frame);
  const bool makeUp = std::exchange(m_unfinished, true);  // until the end, without an exception
  const voxel::FilledSource filled(source, m_params.reading);
  const bool anyColumn = filled.freeUpTo() != m_freeUpTo;  // can have changed
  LayersChange change;
  change.everywhere = makeUp || anyColumn || frame != old;
  if (makeUp || anyColumn)
    rebuildFilled(filled, frame);
  else
    change.columns = follow(filled, inside);
  return change;
}

/** \return the columns whose layers may have changed */
voxel::ColumnSet IncrementalLayers::follow(const voxel::VoxelSource& source,
                                           const voxel::ColumnSet& changed)
{
  const grid::GridFrame& frame = m_layers.frame();
  auto columns = changed.dilated(1).clipped(frame);
  Differences found =
      convertColumns(source, changed, columns, m_params, m_threads, m_layers, m_open, false, false);
  voxel::ColumnSet& newGround = found.newGround;
  if (m_params.floorFrom == FloorFrom::Seen && !newGround.empty())
    newGround = SupportPass(m_params, m_open, m_layers).findAround(newGround);
  voxel::ColumnSet ground = std::move(found.newAerial);
  ground.insert(newGround.dilated(GroundPass(m_params, m_layers).reach()).clipped(frame));
  findGround(ground, m_params, m_threads, m_layers);
  columns.insert(ground);
  m_unfinished = false;
  return columns;
}

void IncrementalLayers::clear()
{
  m_layers = Layers();
  m_open = {};
  m_unfinished = false;
  m_freeUpTo.reset();
}

}  // namespace mrpt_mapconv::freespace
