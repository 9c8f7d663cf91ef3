#include <algorithm>

#include "../Furniture.h"

namespace mrpt_mapconv::sim
{
namespace
{
/** Boards between two sides and a back. min, max: corners, x y [m]; direction: its open front looks
 * towards +x, -x, +y or -y; height: above the floor [m], default 1.9; boards: their number, evenly
 * from 8 cm above the floor up to the top, default 5; thickness: of all its parts [m], default
 * 0.025; base, yaw: see Furniture. */
class Shelf : public Furniture
{
 public:
  Shelf(params::StrictSection& section, const Outline& outline)
      : Furniture(section, outline.middle()),
        m_size(outline.size()),
        m_front(readDirection(section)),
        m_height(readPositive(section, "height", 1.9)),
        m_thickness(readPositive(section, "thickness", 0.025))
  {
    std::int32_t boards = 5;
    section.read("boards", boards);
    if (boards < 2 || boards > kMostBoards) section.fail("boards", "within 2 and 100");
    if (!(2 * m_thickness < std::min(m_size.x, m_size.y)))
      section.fail("thickness", "below half of each side");
    if (!(m_height > kFoot + boards * m_thickness))
      section.fail("height", "above that of a foot of 0.08 m and all boards");
    addSidesAndBack();
    const double spacing = (m_height - m_thickness - kFoot) / (boards - 1);
    for (std::int32_t board = 0; board < boards; ++board) addBoard(kFoot + board * spacing);
  }

  static std::unique_ptr<Primitive> read(params::StrictSection& section)
  {
    return std::make_unique<Shelf>(section, readOutline(section));
  }

 private:
  static constexpr double kFoot = 0.08;  //!< height of the space under the lowest board [m]
  static constexpr std::int32_t kMostBoards = 100;

  /** Half of the shelf's width, looking into it, and half of its depth [m]. */
  double halfWidth() const { return (m_front.alongY ? m_size.x : m_size.y) / 2; }
  double halfDepth() const { return (m_front.alongY ? m_size.y : m_size.x) / 2; }

  struct Span
  {
    double from, to;  //!< [m]
  };
  /** A part between two places across the shelf and two on the way from its back to its front. */
  void addPart(const Span& across, Span deep, double bottom, double top)
  {
    if (m_front.backwards) deep = {-deep.to, -deep.from};
    const Span& x = m_front.alongY ? across : deep;
    const Span& y = m_front.alongY ? deep : across;
    add({{x.from, y.from, bottom}, {x.to, y.to, top}});
  }

  void addSidesAndBack()
  {
    const double w = halfWidth(), d = halfDepth();
    addPart({-w, w}, {-d, m_thickness - d}, 0, m_height);
    addPart({-w, m_thickness - w}, {m_thickness - d, d}, 0, m_height);
    addPart({w - m_thickness, w}, {m_thickness - d, d}, 0, m_height);
  }

  void addBoard(double bottom)
  {
    const double w = halfWidth() - m_thickness, d = halfDepth();
    addPart({-w, w}, {m_thickness - d, d}, bottom, bottom + m_thickness);
  }

  mrpt::math::TPoint2D m_size;  //!< [m]
  Direction m_front;
  double m_height, m_thickness;
};

const PrimitiveKind kKind("shelf", Shelf::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
