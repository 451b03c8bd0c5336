// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "haptics/tool/motion/TargetMotion.h"

namespace palpate
{

/// j . y >= bound: the constraint of a touching feature on a small motion. The motion is whitened, so that the metric
/// is the identity: (displacement, rotation times lever arm), both in scene units. j is a unit vector.
struct MotionRow
{
  Vec6 j = Vec6::Zero();
  double bound = 0.0;
};

/// The row of n . (v + w x arm) >= least, n a unit vector and `arm` from the tool's centre.
[[nodiscard]] MotionRow motionRow(const Vec3& n, const Vec3& arm, double least, double characteristic_u) noexcept;

/// The motion nearest to the wished one, and the rows that push.
struct NearestMotion
{
  Vec6 y = Vec6::Zero();
  std::array<int, 6> row{};         ///< numbers of the active rows; the first `count` are valid
  std::array<double, 6> pressure{}; ///< y - wish = sum pressure_i j_row(i), all >= 0
  int count = 0;
  bool feasible = true; ///< false: no motion satisfies every row, and y has no meaning
};

/// argmin |y - wish|^2 subject to j_k . y >= bound_k: the dual active-set method of Goldfarb & Idnani (1983) in six
/// unknowns. At most six rows are active; they are orthogonalised anew after each change, so that errors do not grow.
/// The motion is unique, the pressures are not where more rows touch than there are degrees of freedom. Real-time safe.
[[nodiscard]] NearestMotion nearestMotion(std::span<const MotionRow> rows, const Vec6& wish) noexcept;

} // namespace palpate
