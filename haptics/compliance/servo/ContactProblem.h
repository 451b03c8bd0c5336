// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "haptics/core/Types.h"

namespace palpate
{

/// Contacts that share compliance: displacement = free + compliance force, three rows per contact, along its normal and
/// two tangents. Of fixed capacity: nothing is allocated. Some 120 kB: not for the stack.
struct ContactProblem
{
  static constexpr int most = 40;
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3 * most, 1>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3 * most, 3 * most>;

  int count = 0;
  double friction = 0.0; ///< mu >= 0
  Square compliance;     ///< [u/N], symmetric, positive semidefinite
  Numbers free;          ///< gap and slip without forces [u]

  /// Sets the size for so many contacts; the numbers are not set.
  void resize(int contacts) noexcept;
};

/// Forces of all contacts, three numbers each [N], and the residual of the contact laws [u].
struct ContactForces
{
  ContactProblem::Numbers force_N;
  double residual_u = 0.0;
  double tolerance_u = 0.0; ///< a residual of the size of rounding: nothing is gained below
  int steps = 0;
  std::uint32_t work = 0; ///< done, in the unit of ContactPlan::workBudget
};

/// Signorini without friction: gap >= 0, force >= 0, one of them 0. By the dual active set of Goldfarb & Idnani (1983),
/// exact but for rounding: a contact whose normal depends on those of others replaces one of them, and one
/// that conflicts with the others gets no force. Tangential forces are 0. Real-time safe.
void solveGaps(const ContactProblem& problem, ContactForces& forces) noexcept;
/// The same for the normal forces alone, under the tangential ones of forces.force_N, which stay.
void closeGaps(const ContactProblem& problem, ContactForces& forces) noexcept;

/// Workspace of the friction solver, owned by the caller.
struct FrictionScratch
{
  ContactProblem::Square jacobian;
  ContactProblem::Numbers moved;
  ContactProblem::Numbers residual;
  ContactProblem::Numbers part;
  ContactProblem::Numbers step;
  ContactProblem::Numbers trial;
  ContactProblem::Numbers least;
  ContactProblem::Numbers best;
  ContactProblem::Numbers swept;
  ContactProblem::Numbers start;
  ContactForces normal;
};

/// How forces with friction are searched for.
struct FrictionSearch
{
  double enough_u = 0.0; ///< a residual that is small enough; 0: only one of the size of rounding is
  /// Contacts along one body that slides as a whole, which have nearly one compliance along it, so that sweeps hardly
  /// converge. The search begins with the exact normal forces under the present tangential ones; then Newton steps may
  /// raise the residual for a while, up to the largest of the last ones (Grippo, Lampariello & Lucidi 1986), with any
  /// number of contacts.
  bool inARow = false;
};

/// Signorini and Coulomb: in contact either no slip within the cone, or slip against the force on the cone. Begins with
/// forces.force_N, which must have the problem's size. A few sweeps of projected Gauss-Seidel, then semismooth Newton
/// steps on Alart & Curnier's (1991) function with a line search; more sweeps where a step does not help. Beyond 20
/// contacts sweeps alone, which are then cheaper. The best forces are kept and lie in their cones, also where
/// `budget` ended the solution, in the unit of ContactPlan::workBudget. Real-time safe.
void solveFriction(const ContactProblem& problem, FrictionScratch& room, ContactForces& forces,
  std::uint32_t budget = std::numeric_limits<std::uint32_t>::max(), const FrictionSearch& how = {}) noexcept;

/// Derivative of forces that meet the laws by small displacements of the rows [u], a column each, while each contact
/// stays open, stuck or slipping, into `answer_N`, of the same size. False, and zeros, where that is not determined.
/// Real-time safe.
[[nodiscard]] bool answerFriction(const ContactProblem& problem, FrictionScratch& room, const ContactForces& forces,
  const Eigen::Ref<const Eigen::MatrixXd>& displaced, Eigen::Ref<Eigen::MatrixXd> answer_N) noexcept;

} // namespace palpate
