#pragma once

#include <mrpt_mapconv/voxel/RegionTable.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>

namespace mrpt_mapconv::voxel
{
/** The log-odds of a voxel that was never touched: −0. Of any known voxel they are another number
 * (0 is +0), and adding to it is as adding to 0. */
constexpr float kUntouched = -0.0f;

constexpr std::int32_t kUntouchedBits = INT32_MIN;  //!< its bits

inline bool isTouched(float logOdds)
{
  std::int32_t bits;
  std::memcpy(&bits, &logOdds, sizeof(bits));
  return bits != kUntouchedBits;
}

/** An occupancy grid of voxels in hashed bricks of 16³ log-odds (float32); a brick whose voxels are
 * all equal is kept as that one value. Voxels that were never touched are a state of their own.
 *
 * Scans come in by insertRays() (RayInsertion.h) and insertScan() (VoxelInsertion.h); what reads
 * voxel maps reads this one through VoxelGridSource.
 */
class VoxelGrid
{
 public:
  struct alignas(64) Brick
  {
    explicit Brick(float value) { logOdds.fill(value); }
    std::array<float, kBrickVoxels> logOdds;
  };
  /** A brick, or the value of all of its voxels. */
  struct Slot
  {
    std::unique_ptr<Brick> brick;
    float value = kUntouched;  //!< of all voxels, while there is no brick

    bool isUntouched() const { return !brick && !isTouched(value); }
    float at(std::size_t index) const { return brick ? brick->logOdds[index] : value; }
    /** Its voxels one by one, for writing. */
    Brick& expanded();
    /** Gives the brick up if its voxels are all equal. */
    void collapse();
  };
  using Table = RegionTable<Slot>;

  /** \param resolution size of a voxel [m]
   * \exception std::invalid_argument unless it is 0.0001 to 1000 m */
  explicit VoxelGrid(double resolution);
  VoxelGrid(const VoxelGrid& o);
  VoxelGrid& operator=(const VoxelGrid& o);
  VoxelGrid(VoxelGrid&&) = default;
  VoxelGrid& operator=(VoxelGrid&&) = default;

  double resolution() const { return m_resolution; }
  /** Scales the map: keys and log-odds stay.
   * \exception std::invalid_argument as the constructor */
  void setResolution(double resolution);
  /** Log-odds from which on a voxel is occupied; a touched one below is free. */
  float occupiedFrom() const { return m_occupiedFrom; }
  void setOccupiedFrom(float logOdds) { m_occupiedFrom = logOdds; }

  /** kUntouched if it was never touched. */
  float logOdds(const VoxelKey& voxel) const;
  /** Sets a voxel; kUntouched makes it unknown, −0 is not kept apart from that. */
  void set(const VoxelKey& voxel, float logOdds);
  /** Sets the cube of side³ voxels with its lowest corner there; side is a power of two that
   * divides the corner's keys. */
  void fillCube(const VoxelKey& lowest, std::int32_t side, float logOdds);
  /** Makes all voxels unknown; the resolution stays. */
  void clear()
  {
    m_table.clear();
    m_bytesAtMost = 0;
  }
  /** Whether no voxel was ever touched. */
  bool empty() const;
  /** How many voxels have been touched. */
  std::size_t size() const;
  /** What the grid has on the heap; counts its bricks. */
  std::size_t heapBytes() const;
  /** The same or more, but known at once: what was counted last and all that was announced since.
   */
  std::size_t heapBytesAtMost() const { return m_bytesAtMost; }
  /** Announces bricks and regions that are going to be added to table(). */
  void announce(std::size_t bytes) { m_bytesAtMost += bytes; }
  void countHeapBytes() { m_bytesAtMost = heapBytes(); }

  const Table& table() const { return m_table; }
  /** For writing; whoever adds to it announces that first. */
  Table& table() { return m_table; }

 private:
  double m_resolution;
  float m_occupiedFrom = 0;
  std::size_t m_bytesAtMost = 0;
  Table m_table;
};

}  // namespace mrpt_mapconv::voxel
