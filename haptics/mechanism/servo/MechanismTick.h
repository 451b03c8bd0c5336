// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <span>

#include "haptics/compliance/servo/PressedBody.h"
#include "haptics/mechanism/constraints/ConstraintChange.h"
#include "haptics/mechanism/servo/MechanismState.h"

namespace palpate
{

class StandingMeshes;

/// Input of one tick of a mechanism.
struct MechanismInput
{
  std::uint64_t tick = 0;
  double dt_s = 1e-3;
  const MechanismPlan* plan = nullptr;
  Pose hand_W; ///< of the device; its turn is not looked at where the grip leaves it free
  MechanismGrip grip;
  double turnBy_rad = 0.0; ///< turn of a wire's outer end in this tick in addition to the hand's
  std::uint32_t wireBudget = std::numeric_limits<std::uint32_t>::max(); ///< in the unit of ContactPlan::workBudget
  std::span<const PressedBody* const>
    soft;                                 ///< newest of each, in the plan's order; null: not there, without constraints
  const FoundContacts* found = nullptr;   ///< newest answer of the finder; null: nothing is looked for
  const StandingMeshes* meshes = nullptr; ///< of the mesh in the hand, then of bodies that stand; null: none is guarded
};

struct MechanismEvent
{
  std::uint64_t tick = 0;
  ConstraintChange change = ConstraintChange::Punctured;
  std::uint32_t law = 0; ///< in the plan
  double force_N = 0.0;  ///< that did it
};

/// State of a constraint in a tick, of one that was found as well.
struct ConstraintNow
{
  ConstraintPhase phase = ConstraintPhase::Open;
  Vec3 force_W = Vec3::Zero(); ///< on A [N]
  Vec3 at_W = Vec3::Zero();    ///< where, as it has yielded
  double inside_u = 0.0;       ///< of the shaft, beyond its hole
};

/// A force on a soft body, for the worker that computes it.
struct MechanismPress
{
  int soft = 0; ///< in the plan's order
  int from = 0; ///< the other body of the constraint, in the plan
  SurfacePoint at;
  Vec3 force_N = Vec3::Zero(); ///< on the body
};

/// Result of one tick.
struct MechanismResult
{
  Wrench wrench_W;        ///< on the hand, about the held body's origin: N, N u; changes are spread over 30 ms
  Wrench exact_W;         ///< the same as the constraints have it now
  double stored_Nu = 0.0; ///< elastic energy of grip, constraints and soft bodies under these forces
  int rows = 0;
  std::uint32_t work = 0;  ///< of the solver in all solves of the tick, in the unit of ContactPlan::workBudget
  bool capped = false;     ///< the constraints are not met, by lawWorkBudget or by any place: the next tick goes on
  double residual_u = 0.0; ///< largest of the constraints'
  PosesOfBodies pose_W{};  ///< of held and rigid bodies
  std::array<ConstraintNow, Mechanism::mostConstraints> laws{}; ///< the plan's, then those that were found
  int found = 0;                                                ///< how many of these were found
  bool ahead = false; ///< the hand is ahead of the mesh, which goes no further than contacts were looked for
  int eventCount = 0;
  std::array<MechanismEvent, Mechanism::mostConstraints> events{};
  int pressCount = 0;
  std::array<MechanismPress, 2 * Mechanism::mostConstraints> presses{};
  WireReport wire; ///< of the body in the hand
};

/// A mechanism as no tick has moved it yet, by another plan: each constraint open, each place where its constraint is
/// joined.
void beginAnew(const MechanismPlan& plan, MechanismState& state) noexcept;

struct MechanismScratch;

/// Moves a mechanism and solves its constraints: one problem in the space of their rows, in which the compliances of
/// grip, soft bodies and springs add up (W = sum J C J^T), each constraint exact. Deterministic, bounded, real-time
/// safe but for making and ending it.
class MechanismTick
{
public:
  MechanismTick();
  ~MechanismTick();
  MechanismTick(MechanismTick&&) noexcept;
  MechanismTick& operator=(MechanismTick&&) noexcept;

  /// Once a tick. Another plan, by its revision, begins anew. A hand's pose that is not finite gives no force.
  [[nodiscard]] const MechanismResult& step(const MechanismInput& input) noexcept;
  /// A person breaks a constraint: from the next step on it is gone.
  void breakConstraint(std::uint32_t law) noexcept;

  [[nodiscard]] const MechanismState& state() const noexcept { return this->state_; }
  /// To go on from where a recording begins.
  void restore(const MechanismState& state) noexcept { this->state_ = state; }

private:
  MechanismState state_;
  std::unique_ptr<MechanismScratch> room_;
};

} // namespace palpate
