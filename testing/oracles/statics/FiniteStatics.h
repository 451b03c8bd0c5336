// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "testing/oracles/statics/Jet.h"

namespace palpate::test
{

/// Statics of bodies that turn by any angle: an energy of coordinates and of multipliers of constraints is made
/// stationary by Newton's method with its full second derivatives. Dense, by differentiation of the energy alone,
/// without any code of the product.
class FiniteStatics
{
public:
  using Coordinates = std::vector<Jet>;
  using Energy = std::function<Jet(const Coordinates&)>;

  /// From z, as far as doubles reach. False where that does not end.
  static bool makeStationary(const Energy& energy, Eigen::VectorXd& z);

  /// The coordinates k, k + 1, k + 2.
  static JetVector vectorOf(const Coordinates& z, std::size_t k) { return { z[k], z[k + 1], z[k + 2] }; }
  static JetVector constant(const Eigen::Vector3d& v, const Coordinates& z);
  /// r after the turn by a rotation vector (Rodrigues' formula).
  static JetVector turned(const JetVector& turn, const JetVector& r);
};

} // namespace palpate::test
