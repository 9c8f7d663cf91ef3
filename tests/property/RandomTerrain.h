#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "../oracle/TerrainOracle.h"
#include "RandomMap.h"

namespace mrpt_mapconv::test
{
/** Points in a sensor's frame that is the map's. */
struct TerrainPoints
{
  std::vector<float> x, y, z;

  /** In the middle of a cell. */
  void add(int kx, int ky, double height);
  std::size_t size() const { return x.size(); }
  terrain::TerrainScan scan() const;
};

/** Floors, platforms, stairs, ramps and rotated, tilted plates of noise-free cells.
 *
 * Their planes can be told apart: levels differ by more than twice the tolerance, between others a
 * plane in the middle fits both; each plane holds a square of 5 cells, and slopes leave the
 * tolerance within its half. Ramps leave their floor from the first row on. */
class RandomTerrain
{
 public:
  static constexpr double kResolution = 0.05;  // [m]
  /** Of maps that can tell its planes apart. */
  static terrain::TerrainParams params();

  explicit RandomTerrain(Rng& rng);

  struct Cell
  {
    int label = 0;  //!< cells with equal ones are on one plane
    double z = 0;   //!< [m]
  };
  const std::map<oracle::TerrainKey, Cell>& cells() const { return m_cells; }
  oracle::TerrainLabels labels() const;
  /** A point for each cell. */
  TerrainPoints points() const;
  /** One or more for each cell, and heaps of rubble. \param sigma of their heights [m] */
  TerrainPoints noisyPoints(Rng& rng, double sigma) const;

 private:
  struct Piece
  {
    double x = 0, y = 0, angle = 0;  //!< middle [cells], of its sides
    double halfX = 0, halfY = 0;     //!< [cells]
    double z = 0;                    //!< in the middle [m]
    double slopeX = 0, slopeY = 0;   //!< along its sides [m per cell]
  };
  void add(const Piece& piece);
  int labelOf(const Piece& piece);
  void addStairs(Rng& rng);
  void addRamp(Rng& rng);
  void addPlate(Rng& rng, bool tilted);
  void cutHole(Rng& rng);
  void dropNarrowPlanes();
  Piece somewhere(Rng& rng, int least, int most) const;

  int m_width, m_height, m_x0, m_y0, m_tilted = 0;
  std::map<oracle::TerrainKey, Cell> m_cells;
  std::map<std::vector<std::int64_t>, int> m_labels;
};

/** The points in a random order. */
void shuffle(Rng& rng, TerrainPoints& points);
/** Points as several scans: patches of what a sensor sees in a place, or any. Each point is in at
 * least one, some in as many as `times`. */
std::vector<TerrainPoints> asScans(Rng& rng, const TerrainPoints& points, int times = 2);

}  // namespace mrpt_mapconv::test
