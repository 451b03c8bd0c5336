// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "haptics/compliance/servo/PressedBody.h"
#include "haptics/compliance/snapshot/PointCompliance.h"
#include "haptics/geometry/tree/TreeWalk.h"
#include "haptics/mechanism/servo/MechanismTick.h"
#include "haptics/mechanism/sided/SidedSurface.h"

namespace palpate
{

/// The forces on a soft body that bend it, by the same compliance as in the tick.
class BentBy
{
public:
  /// `without`: forces of that body of the plan are its own ones; below 0: all are.
  BentBy(const PressedBody* soft, int soft_i, int without, std::span<const MechanismPress> presses);

  [[nodiscard]] bool bends() const { return !this->forces_.empty(); }
  /// No place goes further [u].
  [[nodiscard]] double most_u() const { return this->most_u_; }
  /// By the own forces, or by all others.
  [[nodiscard]] Vec3 by(const SurfacePoint& at, bool own) const;

private:
  struct Force
  {
    CompliantPoint at;
    Vec3 force_N;
    bool isOwn; ///< one of those without which places are judged
  };

  [[nodiscard]] Vec3 by(const CompliantPoint& at, bool own) const;

  const PressedBody* soft_;
  std::vector<Force> forces_;
  double most_u_ = 0.0;
};

[[nodiscard]] inline Box widened(const Box& box, double by_u)
{
  return { box.low_W.array() - by_u, box.high_W.array() + by_u };
}

[[nodiscard]] inline SurfacePoint placeAt(std::uint32_t v, const std::vector<Vec3>& free_W)
{
  return { { v, v, v }, Vec3(1.0, 0.0, 0.0), free_W[v] };
}

/// One of two surfaces, as the forces bend it near the other one.
struct SoftAsMesh
{
  const SidedSurface& surface;
  const std::vector<Vec3>& free_W; ///< vertices without forces, of a soft body or of one that stands
  std::vector<Vec3> without_W;     ///< near the other as the forces bend them that are not between the two
  std::vector<Vec3> bent_W;        ///< near the other as all forces bend them
  double bent_u = 0.0;             ///< none of them is further from where it is free
  std::vector<std::uint32_t> near; ///< vertices near the other
  Box around = Box::empty();       ///< of these, where they are bent

  /// The vertices of triangles in that box are near.
  void bend(const BentBy& bending, const Box& reached);
  /// A place of the bent surface, as a place of the free one.
  [[nodiscard]] SurfacePoint placeOn(std::uint32_t triangle, const Vec3& at_W) const;
  [[nodiscard]] SurfacePoint placeAlong(std::uint32_t a, std::uint32_t b, double share) const;
  /// A place where it is without the forces between the two.
  [[nodiscard]] Vec3 withoutAt(const SurfacePoint& place) const;
  /// A third of the triangles at a vertex that are turned to that side [u^2].
  [[nodiscard]] double areaAround(std::uint32_t v, const Vec3& out_W) const;
};

} // namespace palpate
