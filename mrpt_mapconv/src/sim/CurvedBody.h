#pragma once

#include <mrpt_mapconv/sim/Primitive.h>

#include <vector>

namespace mrpt_mapconv::sim
{
/** A primitive that is one curved body, such as an UprightCylinder. */
template <class Body>
class CurvedBody : public Primitive
{
 public:
  explicit CurvedBody(const Body& body) : m_body(body) {}

  Footprint footprint() const override { return m_body.footprint(); }
  void appendMesh(Mesh& mesh) const override { m_body.appendMesh(mesh); }
  const CurvedSurface* curved() const override { return &m_body; }
  void appendSolids(double x, double y, std::vector<Solid>& solids) const override
  {
    m_body.appendSolids(x, y, solids);
  }

 private:
  Body m_body;
};

}  // namespace mrpt_mapconv::sim
