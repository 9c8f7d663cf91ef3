#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/params/StrictSection.h>
#include <mrpt_mapconv/sim/Foliage.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mrpt_mapconv::sim
{
class World;

/** The part of a vertical line that lies inside a solid. */
struct Solid
{
  double bottom = 0, top = 0;  //!< z of its ends [m]
  double slope = 0;            //!< of the upper face at this place [m/m]
};

/** A horizontal rectangle [m]. */
struct Footprint
{
  double xMin = 0, yMin = 0, xMax = 0, yMax = 0;
};

/** Triangles in the world's frame [m]. */
struct Mesh
{
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  //!< indices of vertices
};

/** A surface that rays meet exactly, where triangles would only come near. */
class CurvedSurface
{
 public:
  struct Meeting
  {
    double range = 0;                //!< [m]
    mrpt::math::TVector3D outwards;  //!< normal of the surface, of any length
  };
  virtual ~CurvedSurface() = default;
  /** Lower and upper corner of a box around it [m]. */
  virtual std::array<mrpt::math::TPoint3D, 2> bounds() const = 0;
  /** Where a ray, from outside or inside, first meets it between minRange and maxRange [m].
   * \param direction of length 1 */
  virtual std::optional<Meeting> meet(const mrpt::math::TPoint3D& origin,
                                      const mrpt::math::TVector3D& direction, double minRange,
                                      double maxRange) const = 0;
};

/** Where a body that moves is at which time. */
class Motion
{
 public:
  virtual ~Motion() = default;
  /** How far it is from the place where its surface says that it is [m].
   * \param seconds since the start */
  virtual mrpt::math::TVector3D shiftAt(double seconds) const = 0;
};

/** A body that a world is made of. Its surface is seen by rays, its inside is known for the truth;
 * both describe the same geometry.
 *
 * A new primitive is one file in src/sim/primitives: a class, and a PrimitiveKind that says how it
 * is named and read.
 */
class Primitive
{
 public:
  virtual ~Primitive() = default;
  /** The smallest rectangle that holds it, at all times. */
  virtual Footprint footprint() const = 0;
  /** Adds the triangles of its surface; those of a curved one only come near it. */
  virtual void appendMesh(Mesh& mesh) const = 0;
  /** What rays meet instead of the mesh; nullptr: they meet the mesh. */
  virtual const CurvedSurface* curved() const { return nullptr; }
  /** What rays meet instead of the mesh where a body has no surface; nullptr: it has one. */
  virtual const Foliage* foliage() const { return nullptr; }
  /** Whether it is the ground that trees stand on, and that ground filters look for. */
  virtual bool isGround() const { return false; }
  /** Adds the parts of the vertical line through (x, y) [m] that are inside. */
  virtual void appendSolids(double x, double y, std::vector<Solid>& solids) const = 0;
  /** Share of the rays that go through all of it unseen, 0 … 1 (glass); of a mirror, of those that
   * it does not reflect. */
  virtual double transparency() const { return 0; }
  /** Share of the rays that its faces reflect like a mirror where they are met at a right angle,
   * 0 … 1; more do so where they are met at others, see Sensor. A body that has any is convex. */
  virtual double mirror() const { return 0; }
  /** How it moves; nullptr: it does not. What moves has a curved() surface and is no part of the
   * truth. */
  virtual const Motion* motion() const { return nullptr; }
};

using Bodies = std::vector<std::unique_ptr<Primitive>>;

/** Registers a kind of primitive: sections [kind.NAME] of a world file are read by `read`.
 *
 * `read` takes the keys it knows from the section (which complains about the rest) and throws by
 * StrictSection::fail() for values that make no body.
 */
struct PrimitiveKind
{
  using Reader = std::unique_ptr<Primitive> (*)(params::StrictSection& section);
  /** For what stands on the ground, one body or many.
   * \param world with all bodies that do not, see World::groundAt() */
  using StandingReader = Bodies (*)(params::StrictSection& section, const World& world);
  PrimitiveKind(const char* kind, Reader read);
  PrimitiveKind(const char* kind, StandingReader read);

  Reader read = nullptr;                  //!< one of
  StandingReader readStanding = nullptr;  //!< the two

  /** Names of all kinds, in alphabetical order. */
  static std::vector<std::string> names();
  /** \return nullptr for a kind that is not registered */
  static const PrimitiveKind* find(const std::string& kind);
};

}  // namespace mrpt_mapconv::sim
