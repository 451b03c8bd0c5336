// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// Turns and shifts a mesh and the hand's path alike, so that no coordinate is a round number.
class Anywhere
{
public:
  /// No coordinate is shifted by more than `furthest_u`.
  Anywhere(Random& random, double furthest_u)
    : turn_(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)),
      shift_W_(random.inCube(furthest_u))
  {
    this->turn_.normalize();
  }
  [[nodiscard]] Vec3 operator()(const Vec3& v) const { return this->turn_ * v + this->shift_W_; }
  [[nodiscard]] TriangleMesh operator()(const TriangleMesh& mesh) const
  {
    return shifted(rotated(mesh, this->turn_), this->shift_W_);
  }

private:
  Quat turn_;
  Vec3 shift_W_;
};

} // namespace palpate::test
