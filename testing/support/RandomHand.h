// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// A hand that does anything over a surface, one tick of 1 ms a call: it glides from place to place, dashes, strokes in
/// circles, trembles by encoder steps, and presses from one side through to the other.
class RandomHand
{
public:
  /// `mesh` must outlive it. `depth_u`: how far on either side of the surface its goals lie.
  RandomHand(const TriangleMesh& mesh, double depth_u, std::uint64_t seed);

  [[nodiscard]] Vec3 next();

  /// It has been led elsewhere: it goes on from there.
  void moveTo(const Vec3& p_W);

private:
  enum class Stroke
  {
    Glide,
    Dash,
    Rub,
    Tremble
  };
  void beginStroke();
  [[nodiscard]] Vec3 goalAtSurface();

  const TriangleMesh& mesh_;
  double depth_u_;
  Random random_;
  Stroke stroke_ = Stroke::Dash;
  int ticksLeft_ = 0, ticks_ = 1;
  Vec3 p_W_ = Vec3::Zero(), from_W_ = Vec3::Zero(), goal_W_ = Vec3::Zero();
  Vec3 right_ = Vec3::UnitX(), up_ = Vec3::UnitY(); ///< of the circle that it strokes, [u] long
};

} // namespace palpate::test
