#include <mrpt_mapconv/grid/Resolution.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelGridSource.h>
#include <mrpt_mapconv/voxel/VoxelMap.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "BeamInsertion.h"
#include "OccupancyModel.h"
#include "OctreeToGrid.h"

namespace mrpt_mapconv::voxel
{
VoxelMap::VoxelMap(double resolution) : m_resolution(resolution), m_grid(std::in_place, resolution)
{
}

VoxelMap::~VoxelMap() = default;

VoxelMap::VoxelMap(const VoxelMap& o)
    : m_resolution(o.m_resolution), m_model(o.m_model), m_grid(o.m_grid)
{
  if (!m_grid) m_tree = std::make_unique<octomap::OcTree>(*o.m_tree);
}

VoxelMap& VoxelMap::operator=(const VoxelMap& o)
{
  if (this != &o) *this = VoxelMap(o);
  return *this;
}

VoxelMap::VoxelMap(VoxelMap&& o) noexcept : VoxelMap(o.m_resolution) { *this = std::move(o); }

VoxelMap& VoxelMap::operator=(VoxelMap&& o) noexcept
{
  std::swap(m_resolution, o.m_resolution);
  std::swap(m_model, o.m_model);
  std::swap(m_grid, o.m_grid);
  std::swap(m_tree, o.m_tree);
  return *this;
}

bool VoxelMap::empty() const { return m_grid ? m_grid->empty() : m_tree->size() == 0; }

std::size_t VoxelMap::size() const { return m_grid ? m_grid->size() : knownVoxels(*source()); }

std::unique_ptr<VoxelSource> VoxelMap::source() const
{
  if (m_grid) return std::make_unique<VoxelGridSource>(*m_grid);
  return std::make_unique<OctreeSource<octomap::OcTree>>(*m_tree);
}

const octomap::OcTree& VoxelMap::octree() const
{
  const std::lock_guard<std::mutex> lock(m_making);
  if (!m_tree)
  {
    auto tree = toOcTree(*m_grid, m_model.pruning);
    m_model.applyTo(*tree);
    m_tree = std::move(tree);
  }
  return *m_tree;
}

std::string VoxelMap::fullOctree() const
{
  return m_grid ? voxel::fullOctree(*m_grid, m_model.pruning) : voxel::fullOctree(*m_tree);
}

void VoxelMap::writeOctreeFile(const std::string& path) const
{
  if (m_grid)
    voxel::writeOctreeFile(path, *m_grid, m_model.pruning);
  else
    voxel::writeOctreeFile(path, *m_tree);
}

void VoxelMap::setModel(const TVoxelInsertionOptions& model)
{
  m_model = model;
  if (!m_grid) return model.applyTo(*m_tree);
  m_grid->setOccupiedFrom(OccupancyModel(model).occupiedFrom);
  m_tree.reset();
}

void VoxelMap::setOctree(std::unique_ptr<octomap::OcTree> tree)
{
  if (!tree) throw std::invalid_argument("no octree given");
  grid::requireResolution(tree->getResolution());
  m_resolution = tree->getResolution();
  m_model.adoptFrom(*tree);
  m_tree = std::move(tree);
  m_grid.reset();
}

void VoxelMap::setFullOctree(std::string_view bytes, const std::string& name, double resolution,
                             const std::optional<std::int32_t>& maxMemory)
{
  grid::requireResolution(resolution);
  const auto checkScale = [&](double own)
  {
    if (!(std::abs(own / resolution - 1) < 1e-5))
      throw std::runtime_error(name + ": two different resolutions");
  };
  std::unique_ptr<octomap::OcTree> tree;
  std::optional<VoxelGrid> grid;
  try
  {
    grid = readVoxelGrid(bytes, name, maxMemory);
    checkScale(grid->resolution());
    grid->setResolution(resolution);
    grid->setOccupiedFrom(OccupancyModel(m_model).occupiedFrom);
  }
  catch (const LeafTooLarge&)  // which costs a tree nothing
  {
    tree.reset(dynamic_cast<octomap::OcTree*>(readOctree(std::string(bytes), name).release()));
    checkScale(tree->getResolution());
    tree->setResolution(resolution);
    m_model.applyTo(*tree);
  }
  m_resolution = resolution;
  m_grid = std::move(grid);
  m_tree = std::move(tree);
}

void VoxelMap::setGrid(VoxelGrid grid, const TVoxelInsertionOptions& model)
{
  m_resolution = grid.resolution();
  m_tree.reset();
  m_grid = std::move(grid);
  setModel(model);
}

void VoxelMap::clear()
{
  m_tree.reset();
  m_grid.emplace(m_resolution);
  m_grid->setOccupiedFrom(OccupancyModel(m_model).occupiedFrom);
}

// Until beams are inserted, which can fail, the map stays in the form in which it is.

ColumnSet VoxelMap::insertIntoGrid(const ScanBeams& beams, const TVoxelInsertionOptions& options,
                                   int threads)
{
  if (m_grid)
  {
    m_tree.reset();
    return insertBeams(*m_grid, beams, options, threads);
  }
  VoxelGrid made = toVoxelGrid(*m_tree, options.maxMemory);
  auto changed = insertBeams(made, beams, options, threads);
  m_grid = std::move(made);
  m_tree.reset();
  return changed;
}

ColumnSet VoxelMap::insertIntoOctree(const ScanBeams& beams, const TVoxelInsertionOptions& options)
{
  octree();
  try
  {
    auto changed = insertBeams(*m_tree, beams, options);
    m_grid.reset();
    return changed;
  }
  catch (...)
  {
    if (m_grid) m_tree.reset();  // some of it may have changed
    throw;
  }
}

ColumnSet VoxelMap::insertScan(const observation::SensorPoints& scan,
                               const TVoxelInsertionOptions& options,
                               observation::SayOnceLog* warnings,
                               const std::function<void(const grid::GridFrame&)>& check,
                               int threads)
{
  options.check();
  const ScanBeams beams = beamsOf(m_resolution, scan, options, warnings);
  if (check) check(beams.frame());
  const bool staysPruned = m_model.pruning && !empty();
  auto changed = options.voxelEngine == VoxelEngine::Blocks
                     ? insertIntoGrid(beams, options, threads)
                     : insertIntoOctree(beams, options);
  m_model = options;
  m_model.pruning = options.pruning || staysPruned;
  return changed;
}

}  // namespace mrpt_mapconv::voxel
