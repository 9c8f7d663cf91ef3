#pragma once

#include <mrpt_mapconv/scan/ScanProfile.h>

#include <set>
#include <utility>
#include <vector>

namespace mrpt_mapconv::oracle
{
using CellKeys = std::set<std::pair<int, int>>;

/** What one scan says, cell by cell. */
struct ScanCells
{
  CellKeys occupied, free;
  int lines = 0, linesWithWall = 0;
  bool tie = false;  //!< something was so close that rounding in double may decide otherwise
};

/** The inverse sensor model of the section 1 by its definition: line by line, cell by cell,
 * point by point. For scans and parameters that are good. */
class ScanOracle
{
 public:
  ScanOracle(const std::vector<mrpt::math::TPoint3Df>& points, const scan::Viewpoint& view,
             double resolution, const scan::ProfileParams& params);

  ScanCells profile() const;

  /** The cells that hold an object point, and those that hold a point of the structure. */
  const CellKeys& objectCells() const { return m_object; }
  const CellKeys& wallCells() const { return m_wall; }
  /** Number of lines, and how far from them a structure point may be [rad]. */
  static int lineCount(double resolution, const scan::ProfileParams& params);
  static double structureGap(const scan::Viewpoint& view, const scan::ProfileParams& params);

 private:
  struct Line
  {
    std::vector<std::pair<int, int>> cells;  //!< that it crosses, in order
    long double wall = 0;                    //!< distance of its wall's centre; may be infinite
  };
  struct StructurePoint
  {
    std::pair<int, int> cell;
    long double azimuth;
  };

  void addPoint(const mrpt::math::TPoint3Df& point, const scan::Viewpoint& view);
  Line line(long double dx, long double dy, ScanCells& result) const;
  std::vector<std::pair<int, int>> walk(long double dx, long double dy, ScanCells& result) const;
  long double findWall(const Line& line, long double azimuth, ScanCells& result) const;
  bool isValid(const std::pair<int, int>& cell, long double wall, ScanCells& result) const;
  bool isBeforeWall(const std::pair<int, int>& cell, long double wall, ScanCells& result) const;
  void addWholeShape(const Line& line, ScanCells& result) const;
  void addClosestPoint(const Line& line, ScanCells& result) const;
  void addCellsOffTheLines(const CellKeys& crossed, ScanCells& result) const;
  long double distance(const std::pair<int, int>& cell) const;
  bool inReach(long double x, long double y) const;

  // lengths are in cells from here on
  long double m_resolution, m_sensorX, m_sensorY, m_tolerance, m_reach = 0;
  scan::ProfileParams m_params;
  int m_lines;
  double m_gap;
  CellKeys m_object, m_wall;
  std::vector<StructurePoint> m_structure;  //!< but for points right above or below the sensor
};

}  // namespace mrpt_mapconv::oracle
