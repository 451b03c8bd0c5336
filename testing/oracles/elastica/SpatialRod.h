// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace palpate::test
{

/// A rod that is an arc at rest, clamped along x and bent towards y, with a force at its free end: Cosserat's equations
/// r' = R (e + C R^T n), R' = R [k], k = k0 + D R^T m, m' = -r' x n, solved as a boundary value problem.
struct SpatialRod
{
  double length = 1.0;
  double curvature = 0.0;
  Eigen::Vector3d stretch{ 1.0, 1.0, 1.0 }; ///< E A, k G A, k G A
  Eigen::Vector3d bend{ 1.0, 1.0, 1.0 };    ///< G J, E I, E I

  /// Where the free end comes to rest, by Runge & Kutta's steps and Newton's on the moment of the clamp.
  [[nodiscard]] Eigen::Vector3d tip(const Eigen::Vector3d& force) const;
};

} // namespace palpate::test
