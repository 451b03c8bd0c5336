// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "haptics/compliance/servo/ContactProblem.h"
#include "haptics/mechanism/Mechanism.h"

namespace palpate
{

/// The laws of a mechanism in the space of their rows: moved = free + compliance force + ways way, with forces between
/// their bounds, and ways^T force + load = turns way. `ways` are those of bodies that nothing elastic holds: a device
/// that leaves the turn free, a rigid body that rests on others. Turns count as the way of a lever's end, their moments
/// as forces on it. Of fixed capacity: nothing is allocated. Some 40 kB: not for the stack.
struct LawProblem
{
  static constexpr int most = Mechanism::mostRows;
  static constexpr int mostWays = 24; ///< three bodies that rest, a free turn, and room
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
  Ways along;      ///< how rows move when bodies do
  Way load;        ///< [N] on those bodies
  WaySquare turns; ///< [N/u] how the forces that are there hold what they pull on against turning: symmetric, >= 0
  double yield_u_per_N = 1.0;              ///< the compliance to compare with: any, of the size of the others
  int cones = 0;                           ///< Coulomb's contacts: the last rows, three each, a normal and two across
  std::array<double, most / 3> friction{}; ///< coefficient of each, > 0; bounds are not theirs

  /// For so many rows and ways; numbers are not set.
  void resize(int rows, int freeWays) noexcept;
  [[nodiscard]] int bounded() const noexcept { return this->count - 3 * this->cones; }
};

/// What a problem comes to.
struct LawForces
{
  LawProblem::Numbers force_N;
  LawProblem::Numbers moved_u;
  LawProblem::Way way_u;
  double residual_u = 0.0;   ///< by how much the laws are not met
  double unbalanced_N = 0.0; ///< of the bodies that nothing elastic holds
  std::uint32_t work = 0;    ///< done, in the unit of ContactPlan::workBudget
  bool capped = false;       ///< the laws are not met: the budget is used up, or nothing meets them
  double damping = 0.0;      ///< of the last step towards balance; 0: there was none
};

/// Where the steps towards balance begin.
enum class LawStart : std::uint8_t
{
  Bodies, ///< where the bodies are
  Before, ///< where they ended in the problem before, which differs little
};

/// What the solver needs to work in: kept by who calls it.
struct LawRoom
{
  LawProblem::Square stiffened; ///< compliance with what the free ways add
  LawProblem::Numbers pressed;  ///< free, with what cones and free ways add
  LawProblem::Square conesAnswer;
  LawProblem::Ways conesWays;
  ContactProblem::Square resists; ///< how the laws resist the free ways
  LawProblem::WaySquare held;     ///< the part of what forces hold against turning
  ContactProblem contacts;
  ContactForces contactForces;
  FrictionRoom friction;
  LawProblem::Ways displaced;
  LawProblem::Ways answer;
};

/// What the solves of one tick may do together, in the unit of ContactPlan::workBudget: .5 ms on a machine where a
/// needle in wall and liver takes 205 of it at most and a block that rubs on four springs 3,300
/// (palpate-mechanism-bench). A turn that has begun is ended.
inline constexpr std::uint32_t lawWorkBudget = 15000;

/// Every law at once. Rows by the dual active set (BoundedRows.h). Cones by Coulomb's law (solveFriction) in what the
/// held rows leave them. The free ways are the multipliers of the balance: Newton's steps on it, damped by a drag that
/// fades (Kelley & Keyes 1998), begin where the bodies are, so that of several places of rest friction decides for the
/// one that they come to. No compliance stands for "free". Where `budget` ends it, or no place is one of rest, forces
/// are within their bounds and bodies go by a step against that drag. Forces begin at those of `forces` for cones. A
/// start `Before` that does not lead to balance at once is left for one where the bodies are. Real-time safe.
void solveLaws(const LawProblem& problem, LawRoom& room, LawForces& forces, std::uint32_t budget = lawWorkBudget,
  LawStart start = LawStart::Bodies) noexcept;

} // namespace palpate
