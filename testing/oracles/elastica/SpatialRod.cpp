// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/oracles/elastica/SpatialRod.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace palpate::test
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Place, directions and moment of a section, or how they change along the rod.
struct Section
{
  Vector3d place = Vector3d::Zero();
  Matrix3d frame = Matrix3d::Identity();
  Vector3d moment = Vector3d::Zero();

  [[nodiscard]] Section plus(double step, const Section& slope) const
  {
    return { this->place + step * slope.place, this->frame + step * slope.frame, this->moment + step * slope.moment };
  }
};

Matrix3d crossed(const Vector3d& k)
{
  return (Matrix3d() << 0.0, -k.z(), k.y(), k.z(), 0.0, -k.x(), -k.y(), k.x(), 0.0).finished();
}

Section slopeOf(const SpatialRod& rod, const Section& at, const Vector3d& force)
{
  const Vector3d strain = (at.frame.transpose() * force).cwiseQuotient(rod.stretch);
  const Vector3d bent = (at.frame.transpose() * at.moment).cwiseQuotient(rod.bend);
  Section slope;
  slope.place = at.frame * (Vector3d::UnitX() + strain);
  slope.frame = at.frame * crossed(bent + rod.curvature * Vector3d::UnitZ());
  slope.moment = -slope.place.cross(force);
  return slope;
}

/// From the clamp, with this moment there, to the free end.
Section freeEnd(const SpatialRod& rod, const Vector3d& clamp, const Vector3d& force)
{
  constexpr int steps = 2000;
  const double h = rod.length / steps;
  Section at;
  at.moment = clamp;
  for (int i = 0; i < steps; ++i)
  {
    const Section a = slopeOf(rod, at, force);
    const Section b = slopeOf(rod, at.plus(0.5 * h, a), force);
    const Section c = slopeOf(rod, at.plus(0.5 * h, b), force);
    const Section d = slopeOf(rod, at.plus(h, c), force);
    at = at.plus(h / 6.0, a).plus(h / 3.0, b).plus(h / 3.0, c).plus(h / 6.0, d);
  }
  return at;
}

} // namespace

Vector3d SpatialRod::tip(const Vector3d& force) const
{
  constexpr int parts = 10, newton = 8;
  Vector3d clamp = Vector3d::Zero();
  for (int part = 1; part <= parts; ++part)
  {
    const Vector3d now = force * part / parts;
    for (int i = 0; i < newton; ++i)
    {
      const Vector3d open = freeEnd(*this, clamp, now).moment;
      const double small = 1e-6 * (now.norm() * this->length + 1e-12);
      Matrix3d slopes;
      for (int k = 0; k < 3; ++k)
      {
        slopes.col(k) = (freeEnd(*this, clamp + small * Vector3d::Unit(k), now).moment - open) / small;
      }
      clamp -= slopes.inverse() * open;
    }
  }
  return freeEnd(*this, clamp, force).place;
}

} // namespace palpate::test
