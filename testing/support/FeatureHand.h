// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// A hand that is led where contact is hard: to and fro over one vertex, edge or face and through it, exactly through
/// vertices and along edges, exactly under rims, in ticks of a hundredth to a thousand triangles.
class FeatureHand
{
public:
  /// `mesh` must outlive it.
  FeatureHand(const TriangleMesh& mesh, std::uint64_t seed);

  /// Where it is in the next tick.
  [[nodiscard]] Vec3 next();
  [[nodiscard]] double size_u() const noexcept { return this->size_u_; }
  [[nodiscard]] double triangle_u() const noexcept { return this->triangle_u_; }
  /// A place off the surface, at which a ball of up to half of the size may begin.
  [[nodiscard]] Vec3 outside_W() const noexcept { return this->middle_W_ + 2 * this->size_u_ * Vec3::UnitX(); }

private:
  struct Edge
  {
    Vec3 from_W, to_W;
  };
  void beginStroke();
  void glide();
  void passExactly();
  void followEdge();
  void tremble();
  void shoot();
  [[nodiscard]] Edge someEdge();
  [[nodiscard]] Vec3 somePlace();
  [[nodiscard]] Vec3 latticeDirection();
  [[nodiscard]] double stepWithin(double low10, double high10);

  const TriangleMesh& mesh_;
  Random random_;
  double size_u_ = 0.0, triangle_u_ = 0.0;
  Vec3 middle_W_ = Vec3::Zero();
  std::uint32_t triangle_ = 0; ///< that it is at
  Vec3 from_W_ = Vec3::Zero(), step_W_ = Vec3::Zero();
  double shake_u_ = 0.0;
  int tick_ = 1, ticks_ = 0; ///< of the stroke
};

} // namespace palpate::test
