#pragma once

#include <mrpt_mapconv/grid/GridFrame.h>
#include <mrpt_mapconv/params/ListedOptions.h>
#include <mrpt_mapconv/terrain/TerrainParams.h>

namespace mrpt_mapconv::terrain
{
/** How a terrain map begins. */
struct TerrainGridParams
{
  double resolution = 0.05;   //!< L [m]
  double maxGridCells = 1e8;  //!< of the layers; a scan that needs more is refused

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    v("resolution", p.resolution, "m", "size of a cell", params::flag("M"));
    v("maxGridCells", p.maxGridCells, "cells", "a scan that would need larger layers is an error");
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;
  /** \exception std::runtime_error if layers on that frame would have too many cells */
  void checkSize(const grid::GridFrame& frame) const;
};

/** Which points of a scan a map gets. Heights are those above the robot's base. */
struct PointLimits
{
  double maxRange = 30;     //!< [m]
  double minHeight = -100;  //!< [m]
  double maxHeight = 2;     //!< [m]

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    using params::flag;
    v("maxRange", p.maxRange, "m", "points farther from the sensor are left out", flag("M"));
    v("minHeight", p.minHeight, "m",
      "points lower than that above the robot's base are left out; reflections are", flag("M"));
    v("maxHeight", p.maxHeight, "m",
      "points higher than that above the robot's base are left out; it walks under them",
      flag("M"));
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;
};

/** How scans go into a terrain map, as MRPT reads, prints and streams it. */
struct TTerrainInsertionOptions : public params::ListedOptions<TTerrainInsertionOptions>
{
  static constexpr const char* kName = "TTerrainInsertionOptions";
  static constexpr const char* kStreamName = "terrain insertion options";
  static constexpr std::uint8_t kStreamVersion = 0;

  PointLimits limits;
  PointSigmas sigmas;

  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    PointLimits::visit(o.limits, v);
    PointSigmas::visit(o.sigmas, v);
  }
  /** \exception std::invalid_argument naming the option, its value and what would be right */
  void check() const
  {
    limits.check();
    sigmas.check();
  }
};

/** How heights become planes and what a robot can walk on, likewise. */
struct TTerrainOptions : public params::ListedOptions<TTerrainOptions>
{
  static constexpr const char* kName = "TTerrainOptions";
  static constexpr const char* kStreamName = "terrain options";
  static constexpr std::uint8_t kStreamVersion = 0;

  TerrainParams params;

  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    TerrainParams::visit(o.params, v);
  }
  /** \exception std::invalid_argument naming the option, its value and what would be right */
  void check() const { params.check(); }

  /** \exception std::exception for a stream that does not hold valid options */
  void readFromStream(mrpt::serialization::CArchive& in)
  {
    TTerrainOptions read;
    read.ListedOptions::readFromStream(in);
    read.check();
    *this = read;
  }
};

/** What a 3D view of a terrain map shows. */
struct TTerrainSceneOptions
{
  bool showLeaves = true;
  bool showOutlines = true;

  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    v("showLeaves", o.showLeaves, "",
      "draw the leaves, coloured by their planes, instead of the occupancy grid");
    v("showOutlines", o.showOutlines, "", "draw the edges of the leaves that lie in planes");
  }
};

}  // namespace mrpt_mapconv::terrain
