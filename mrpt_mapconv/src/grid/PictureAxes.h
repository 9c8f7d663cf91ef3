#pragma once

#include <vector>

#include "PictureCanvas.h"
#include "PictureTicks.h"

namespace mrpt_mapconv::grid::picture
{
/** Axes in metres at the left of and below a map. */
class Axes
{
 public:
  Axes(const Metrics& metrics, const GridFrame& frame, double pixelsPerCell);

  int leftMargin() const { return m_left; }  //!< room that the labels need, in pixels
  int bottomMargin() const { return m_bottom; }
  int rightMargin() const { return m_right; }

  /** \param x,y,width,height the map's pixels on the canvas */
  void draw(Canvas& canvas, int x, int y, int width, int height) const;

 private:
  GridFrame m_frame;
  double m_pixelsPerMetre;
  std::vector<Tick> m_xTicks, m_yTicks;
  int m_left = 0, m_bottom = 0, m_right = 0;
};

}  // namespace mrpt_mapconv::grid::picture
