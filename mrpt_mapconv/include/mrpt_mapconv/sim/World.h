#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/sim/Primitive.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mrpt_mapconv::sim
{
/** Bodies in a box, as an ini file describes them:
 * \code
 * [world]
 * bounds = -6 -4 -1  8 6 4      // xMin yMin zMin xMax yMax zMax [m]
 * [box.floor]                   // [KIND.NAME], KINDs see src/sim/primitives
 * min = -6 -4 -0.2
 * max = 8 6 0
 * \endcode
 * What is described here is the truth that maps are judged by.
 */
class World
{
 public:
  /** An empty world. \param min, max corners of the box that the truth is asked in [m]; min must be
   * below max on each axis
   * \exception std::invalid_argument if it is not */
  World(const mrpt::math::TPoint3D& min, const mrpt::math::TPoint3D& max);

  /** Reads section [world] and every section [KIND.NAME], those of bodies that stand on the ground
   * after all others; `otherSections` names those that belong
   * to somebody else, exactly ("trajectory") or by their beginning ("sensor.").
   * \exception std::runtime_error in one line naming section, key and value, and what would be
   * right; also for an unknown kind (the known ones are named), an unknown key or no body at all */
  static World fromIni(const mrpt::config::CConfigFileBase& ini,
                       const std::vector<std::string>& otherSections);

  /** \param name as in the file, e.g. "box.floor"; bodies of one section share it */
  void add(std::string name, std::unique_ptr<Primitive> primitive);

  const mrpt::math::TPoint3D& min() const { return m_min; }  //!< lower corner of the bounds [m]
  const mrpt::math::TPoint3D& max() const { return m_max; }  //!< upper corner of the bounds [m]
  std::size_t size() const { return m_primitives.size(); }
  const Primitive& primitive(std::size_t i) const { return *m_primitives[i]; }
  const std::string& name(std::size_t i) const { return m_names[i]; }
  /** True if a body's name, without its kind, begins so: "box.lowWall_1" with "lowWall". */
  bool nameBegins(std::size_t i, const std::string& start) const
  {
    return m_names[i].compare(m_names[i].find('.') + 1, start.size(), start) == 0;
  }

  /** The solid parts of the vertical line through (x, y) [m], merged where they touch or overlap
   * (to 1e-9 m), from the lowest up; the slope is that of the body that forms the top. */
  void solidsAt(double x, double y, std::vector<Solid>& solids) const;
  /** Height of the highest ground at (x, y), see Primitive::isGround() [m]; none: there is none. */
  std::optional<double> groundAt(double x, double y) const;
  /** True if a point [m] lies inside a body. */
  bool isSolid(const mrpt::math::TPoint3D& point) const;
  /** True if a sphere [m] cuts a body by more than 1e-9 m, found by vertical lines on a lattice in
   * it and on its rim, at a spacing of at most `spacing` [m] (bodies thinner than that can be
   * missed). */
  bool sphereHits(const mrpt::math::TPoint3D& centre, double radius, double spacing = 0.01) const;

 private:
  std::size_t cellAt(double x, double y) const;
  std::size_t columnOf(double x) const;
  std::size_t rowOf(double y) const;
  bool lineHits(double x, double y, double bottom, double top, std::vector<Solid>& scratch) const;

  mrpt::math::TPoint3D m_min, m_max;
  std::vector<std::unique_ptr<Primitive>> m_primitives;
  std::vector<std::string> m_names;
  // Which primitives may stand at a place: a coarse grid over the bounds, whose outermost cells
  // also stand for all that lies beyond them.
  double m_cellSize = 1;
  std::size_t m_cellsX = 0, m_cellsY = 0;
  std::vector<std::vector<std::uint32_t>> m_cells;
};

}  // namespace mrpt_mapconv::sim
