#include "../SectionKeys.h"
#include "../UprightCylinder.h"

namespace mrpt_mapconv::sim
{
namespace
{
/** An upright cylinder. base: centre of its lower face, x y z [m]; radius, height [m]. */
class Cylinder : public Primitive
{
 public:
  explicit Cylinder(const UprightCylinder& body) : m_body(body) {}

  static std::unique_ptr<Primitive> read(params::StrictSection& section)
  {
    const auto base = readPoint3D(section, "base");
    const double radius = readPositive(section, "radius");
    return std::make_unique<Cylinder>(
        UprightCylinder(base, radius, readPositive(section, "height")));
  }

  Footprint footprint() const override { return m_body.footprint(); }
  void appendMesh(Mesh& mesh) const override { m_body.appendMesh(mesh); }
  const CurvedSurface* curved() const override { return &m_body; }
  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    m_body.appendSolids(x, y, solids);
  }

 private:
  UprightCylinder m_body;
};

const PrimitiveKind kKind("cylinder", Cylinder::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
