// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "haptics/mechanism/constraints/ConstraintChange.h"
#include "haptics/mechanism/constraints/ConstraintCompliance.h"
#include "haptics/mechanism/servo/MechanismTick.h"

namespace palpate
{

/// Workspace of the constraint solution, kept by the caller. Some 70 kB.
struct SettledScratch
{
  ConstraintRows rows;
  HeldYield held;
  ConstraintProblem problem;
  ConstraintScratch solver;
  ConstraintForces forces;
};

/// The constraints of one tick. Rows are those of small turns; where a hand's spring turns a body, they are made anew
/// at the pose after each solve, with the second derivatives of springs and constraints, until the remainder is of the
/// second order in a negligible turn: Newton's method on the constraints of finite turns. Bodies that only balance
/// holds go on from there in the next tick. Bounded in turns and work. Real-time safe.
class SettledConstraints
{
public:
  SettledConstraints(const MechanismInput& input, MechanismState& state, SettledScratch& room) noexcept;
  SettledConstraints(const SettledConstraints&) = delete;
  SettledConstraints& operator=(const SettledConstraints&) = delete;

  /// From where the bodies were before the tick, at first where they are led.
  void settle() noexcept;

  [[nodiscard]] const ConstraintScene& scene() const noexcept { return this->scene_; }
  [[nodiscard]] const ConstraintRows& rows() const noexcept { return this->room_.rows; }
  /// Where the hand leads the held body from now on.
  void lead(const Pose& lead_W) noexcept { this->lead_W_ = lead_W; }
  /// Only the rows, where the bodies were before the tick.
  void makeRowsFirst() noexcept;
  [[nodiscard]] int rowsOf(int law) const noexcept;
  [[nodiscard]] ConstraintOutcome outcome(int law) const noexcept;
  /// Force of the held body on the hand, about its origin, whitened.
  [[nodiscard]] Vec6 onHand() const noexcept;
  /// The hand's target pose for the held body. A device that leaves the turn free leaves the turn as it was.
  [[nodiscard]] const Pose& lead_W() const noexcept { return this->lead_W_; }
  /// Where the constraints were solved last, and where that brings a body.
  [[nodiscard]] const Pose& reference_W(int body) const noexcept { return this->reference_[body]; }
  [[nodiscard]] Pose movedPose(int body) const noexcept;
  /// From there, whitened.
  [[nodiscard]] const Vec6& motion(int body) const noexcept { return this->motion_[body]; }

  /// The share of its motion that a loose body goes: forces that do not meet the constraints may be any, and change its
  /// way by little in a tick.
  [[nodiscard]] double shareOfLoose(int body) const noexcept;

  [[nodiscard]] std::uint32_t work() const noexcept { return this->work_; }
  /// A further constraint may take some work beside that of a tick.
  void allowMore() noexcept { this->budget_ += lawWorkBudget / 5; }
  [[nodiscard]] bool capped() const noexcept;
  /// No constraint is missed by more, on the bodies as they are turned.
  [[nodiscard]] double residual_u() const noexcept;
  /// Elastic energy of the hand's springs and the constraints, with that of the soft bodies under these forces.
  [[nodiscard]] double stored_Nu() const noexcept;

private:
  void begin() noexcept;
  void takeLoose() noexcept;
  void solve(ConstraintStart start) noexcept;
  [[nodiscard]] bool mayGoOn() const noexcept;
  [[nodiscard]] bool isMet() const noexcept;
  [[nodiscard]] bool isSprung(int body) const noexcept;
  [[nodiscard]] double shareOf(int body) const noexcept;
  [[nodiscard]] bool wentInPart() const noexcept;
  void goOn() noexcept;
  void forgetForces() noexcept;
  void takeForces() noexcept;
  void takeMotions() noexcept;
  [[nodiscard]] Vec6 pressOnHeld() const noexcept;
  [[nodiscard]] double left_u() const noexcept;
  [[nodiscard]] double bent_u() const noexcept;
  [[nodiscard]] double bentAt_u(double arm_u) const noexcept;
  [[nodiscard]] Vec3 movedPlace_W(int body) const noexcept;

  const MechanismInput& input_;
  const MechanismPlan& plan_;
  MechanismState& state_;
  SettledScratch& room_;
  Pose lead_W_;
  std::array<Pose, Mechanism::mostBodies> reference_{};
  std::array<Vec6, Mechanism::mostBodies> motion_{};      ///< of each body from there, whitened
  std::array<LooseYield, Mechanism::mostBodies> loose_{}; ///< of the loose ones
  double share_ = 1.0;                                    ///< of the turns that free bodies can go in one piece
  double heldShare_ = 1.0;                                ///< likewise of the body that the hand's spring turns
  std::uint32_t work_ = 0, budget_ = lawWorkBudget;
  ConstraintScene scene_;
};

} // namespace palpate
