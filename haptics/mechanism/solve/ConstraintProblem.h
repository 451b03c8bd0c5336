// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "haptics/compliance/servo/ContactProblem.h"
#include "haptics/mechanism/Mechanism.h"

namespace palpate
{

/// The constraints of a mechanism in the space of their rows: moved = free + compliance force + along u, with forces
/// between their bounds, and along^T force + load = turns u. The degrees of freedom u (`ways`) belong to bodies without
/// elastic support: a rod whose device leaves the rotation free, a rigid body that rests on others. Rotations are
/// scaled by a lever arm so that all rows are lengths [u] and all multipliers forces [N]. The capacity is fixed:
/// nothing is allocated. The size is some 40 kB: not for the stack.
struct ConstraintProblem
{
  static constexpr int most = Mechanism::mostRows;
  static constexpr int mostWays = 24; ///< three bodies that rest, a free rotation, and a reserve
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;
  using Ways = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, mostWays>;
  using WaySquare = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, mostWays, mostWays>;
  using Way = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, mostWays, 1>;

  int count = 0;
  int ways = 0;
  Square compliance; ///< [u/N], symmetric, positive semidefinite
  Numbers free;      ///< [u]
  Numbers lowest;    ///< of the forces [N]
  Numbers highest;
  Ways along;      ///< Jacobian: motion of the rows per motion of the bodies
  Way load;        ///< [N] on these bodies
  WaySquare turns; ///< [N/u] stiffness of the present forces against rotation of their bodies: symmetric, >= 0
  double yield_u_per_N = 1.0; ///< scale of the compliances, for comparisons
  int cones = 0;              ///< frictional contacts: the last rows, three each, one normal and two tangential
  std::array<double, most / 3> friction{}; ///< coefficient of each, > 0; these rows have no bounds

  /// Sets the numbers of rows and degrees of freedom; values are not set.
  void resize(int rows, int freeWays) noexcept;
  [[nodiscard]] int bounded() const noexcept { return this->count - 3 * this->cones; }
};

/// The solution of a problem.
struct ConstraintForces
{
  ConstraintProblem::Numbers force_N;
  ConstraintProblem::Numbers moved_u;
  ConstraintProblem::Way way_u;
  double residual_u = 0.0;   ///< largest violation of a constraint
  double unbalanced_N = 0.0; ///< residual of the balance of bodies without elastic support
  std::uint32_t work = 0;    ///< done, in the unit of ContactPlan::workBudget
  bool capped = false;       ///< the constraints are not satisfied: budget exhausted, or no solution
  double damping = 0.0;      ///< of the last Newton step; 0: no step
};

/// Start of the Newton steps.
enum class ConstraintStart : std::uint8_t
{
  Bodies, ///< the current configuration
  Before, ///< the solution of the previous, similar problem
};

/// Workspace of the solver, owned by the caller.
struct ConstraintScratch
{
  ConstraintProblem::Square stiffened; ///< compliance plus the share of the free degrees of freedom
  ConstraintProblem::Numbers pressed;  ///< free, plus the shares of cones and free degrees of freedom
  ConstraintProblem::Square conesAnswer;
  ConstraintProblem::Ways conesWays;
  ContactProblem::Square resists;    ///< resistance of the constraints to the free degrees of freedom
  ConstraintProblem::WaySquare held; ///< the active part of the stiffness against rotation
  ContactProblem contacts;
  ContactForces contactForces;
  FrictionScratch friction;
  ConstraintProblem::Ways displaced;
  ConstraintProblem::Ways answer;
};

/// Work limit of all solves of one tick, in the unit of ContactPlan::workBudget: 0.5 ms on a machine where a needle in
/// wall and liver takes at most 205 units and a block with friction on four springs 3,300 (palpate-mechanism-bench).
/// A started iteration is completed.
inline constexpr std::uint32_t lawWorkBudget = 15000;

/// Solves all constraints together: rows by the dual active set (BoundedRows.h), cones by Coulomb friction
/// (solveFriction) in the Schur complement of the active rows. Unconstrained degrees of freedom are solved as
/// equilibrium multipliers by damped Newton (pseudo-transient continuation, Kelley & Keyes 1998) from the current
/// configuration; with friction, this selects the equilibrium that is actually reached. No compliance stands for
/// "free". If `budget` is exhausted, or there is no equilibrium, forces are within their bounds and bodies advance by
/// one damped step. The forces of cones start at those in `forces`. If a start `Before` does not lead to balance at
/// once, the solver starts again at the current configuration. Real-time safe.
void solveConstraints(const ConstraintProblem& problem, ConstraintScratch& room, ConstraintForces& forces,
  std::uint32_t budget = lawWorkBudget, ConstraintStart start = ConstraintStart::Bodies) noexcept;

} // namespace palpate
