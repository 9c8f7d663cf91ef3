#include "Crown.h"

#include "SectionKeys.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3D;

Leaves Leaves::read(params::StrictSection& section)
{
  Leaves leaves;
  leaves.density = readPositive(section, "density");
  section.read("solid", leaves.solid);
  return leaves;
}

std::unique_ptr<Primitive> crownOver(const TPoint3D& foot, const CrownShape& shape,
                                     const Leaves& leaves)
{
  const double middle = (shape.bottom + shape.top) / 2, half = (shape.top - shape.bottom) / 2;
  return std::make_unique<Crown>(Ellipsoid({foot.x, foot.y, foot.z + middle}, shape.radius, half),
                                 leaves);
}

}  // namespace mrpt_mapconv::sim
