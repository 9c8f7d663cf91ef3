#pragma once

#include <mrpt_mapconv/params/Fields.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace mrpt_mapconv::scan
{
/** What an azimuth of a scan says about the cells along it. */
enum class Model
{
  WholeShape,    //!< every object cell is occupied, what lies between them is free
  ClosestPoint,  //!< the nearest object cell is occupied, what lies before it is free
};

/** How files call the models, in the order of the enumeration. */
const std::vector<std::string>& namesOf(Model);

/** How a 3D scan becomes a 2D profile (Mora et al., IEEE Sensors J. 2024, section III). Heights are
 * those above the robot's base. */
struct ProfileParams
{
  static constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

  Model model = Model::WholeShape;
  double objectMinZ = 0.05;       //!< lower end of the object slice [m]
  double objectMaxZ = 1.5;        //!< upper end of it, the robot's height [m]
  bool reflectionFilter = true;   //!< cut what lies behind structural elements
  double structureMinZ = kUnset;  //!< lower end of the structure slice [m]; no default
  double structureMaxZ = kUnset;  //!< upper end of it, just under the ceiling [m]; no default
  double minRange = 0.3;          //!< object points nearer than that are left out, horizontally [m]
  double maxRange = 20;           //!< likewise those farther away [m]
  std::int32_t sectors = 0;       //!< number of lines; 0: see ScanProfile
  double structureGap = -1;       //!< [rad]; −1: half the sensor's azimuth step, at least 0.5°
  double structureTolerance = -1;  //!< [m]; −1: one cell

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    v("model", p.model, "",
      "wholeShape (all objects on an azimuth) or closestPoint (nothing behind the nearest)",
      params::flag("MODEL"));
    v("objectMinZ", p.objectMinZ, "m", "lower end of the object slice; the floor lies below");
    v("objectMaxZ", p.objectMaxZ, "m",
      "upper end of it: what a robot of this height can hit; robotHeight is another name");
    v("reflectionFilter", p.reflectionFilter, "", "cut what is seen through a wall or in it");
    v("structureMinZ", p.structureMinZ, "m",
      "lower end of the structure slice, above the highest furniture; needed by the filter");
    v("structureMaxZ", p.structureMaxZ, "m",
      "upper end of it, just under the ceiling; needed by the filter");
    v("minRange", p.minRange, "m", "objects nearer than that are left out, horizontally");
    v("maxRange", p.maxRange, "m", "objects farther than that are left out, likewise",
      params::flag("M"));
    v("sectors", p.sectors, "",
      "azimuths that are looked along; 0 = at most a cell apart at maxRange");
    v("structureGap", params::Degrees(p.structureGap), "degrees",
      "from a line to a point that is a wall to it; -1 = half the sensor's step, at least 0.5");
    v("structureTolerance", p.structureTolerance, "m",
      "how far behind a wall's cell objects are kept; -1 = one cell");
  }
  /** \exception std::invalid_argument in one line naming the parameter, its value and what would be
   * right; also if the reflection filter has no structure slice */
  void check() const;
  /** True if a height lies in both slices: what stands there is an object, and a wall that cuts
   * what is behind it. False without a structure slice. */
  bool slicesOverlap() const { return structureMinZ < objectMaxZ && structureMaxZ > objectMinZ; }
};

}  // namespace mrpt_mapconv::scan
