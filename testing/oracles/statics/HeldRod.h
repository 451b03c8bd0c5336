// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "testing/oracles/statics/FiniteStatics.h"

namespace palpate::test
{

/// A rigid rod in a hand, held by a spring along every axis and by one of its turn, as an energy of finite turns. The
/// first three coordinates are the place of its origin, the next three its turn from where the hand has it.
struct HeldRod
{
  using Coordinates = FiniteStatics::Coordinates;

  Eigen::Vector3d hand;    ///< where the hand has the origin
  Eigen::Quaterniond turn; ///< and how the rod is turned there
  double coupling = 0.0;   ///< [N/m]
  double turning = 0.0;    ///< [N m/rad]

  [[nodiscard]] Jet energy(const Coordinates& z) const
  {
    const JetVector apart = FiniteStatics::vectorOf(z, 0) - this->hand;
    const JetVector turned = FiniteStatics::vectorOf(z, 3);
    return 0.5 * this->coupling * dot(apart, apart) + 0.5 * this->turning * dot(turned, turned);
  }

  /// A direction of the rod's frame, as it is turned.
  [[nodiscard]] JetVector direction(const Coordinates& z, const Eigen::Vector3d& along) const
  {
    return FiniteStatics::turned(FiniteStatics::vectorOf(z, 3), FiniteStatics::constant(this->turn * along, z));
  }
  /// Where a point of the rod's frame is.
  [[nodiscard]] JetVector point(const Coordinates& z, const Eigen::Vector3d& at) const
  {
    return FiniteStatics::vectorOf(z, 0) + this->direction(z, at);
  }

  /// On the hand, at coordinates that are at rest.
  [[nodiscard]] Eigen::Vector3d force(const Eigen::VectorXd& z) const
  {
    return this->coupling * (z.head<3>() - this->hand);
  }
  [[nodiscard]] Eigen::Vector3d moment(const Eigen::VectorXd& z) const { return this->turning * z.segment<3>(3); }
};

/// Slip of a place under a friction force on it.
struct Rubbed
{
  Eigen::Vector3d slip; ///< from where it rested
  double most = 0.0;    ///< that the friction may be
};

/// The friction force on a place: opposite to its slip and at its most, or less where nothing slips. `under(force)` is
/// `Rubbed`; `yield` is about how much slip goes with force, and grows to the measured ratio. Projected steps, to the
/// end.
template<class Under>
Eigen::Vector3d frictionAt(const Eigen::Vector3d& first, double yield, const Under& under)
{
  constexpr double rounding_N = 1e-6; // a smaller change of the force says nothing of the yield
  Eigen::Vector3d force = first, forceBefore = first, slipBefore = Eigen::Vector3d::Zero();
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 200; ++i)
  {
    const Rubbed now = under(force);
    if (const double way = (force - forceBefore).norm(); way > rounding_N)
    {
      yield = std::max(yield, (now.slip - slipBefore).norm() / way);
    }
    forceBefore = force;
    slipBefore = now.slip;
    Eigen::Vector3d next = force - now.slip / yield;
    if (const double size = next.norm(); size > now.most)
    {
      next *= now.most / size;
    }
    const double change = (next - force).norm();
    force = next;
    if (change == 0.0 || (change < 1e-11 && change >= 0.5 * last))
    {
      break;
    }
    last = change;
  }
  return force;
}

} // namespace palpate::test
