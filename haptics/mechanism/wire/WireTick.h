// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <memory>

#include "haptics/compliance/wire/WireCompliance.h"
#include "haptics/mechanism/wire/WirePlan.h"

namespace palpate
{

/// Input of one tick of a wire.
struct WireInput
{
  const WirePlan* plan = nullptr;
  Pose hand_W;                     ///< its motion along the sheath pushes, its turn about the sheath turns
  double coupling_N_per_u = 0.0;   ///< of the hand's spring along the sheath
  double turning_Nu_per_rad = 0.0; ///< likewise about it; 0: the sheath holds the outer end's turn
  double turnBy_rad = 0.0;         ///< turn of the outer end in this tick in addition to the hand's
  std::uint32_t budget = std::numeric_limits<std::uint32_t>::max(); ///< in the unit of ContactPlan::workBudget
};

/// A force of the wall on the wire.
struct WirePress
{
  int beam = 0;
  Vec3 at_M = Vec3::Zero();    ///< on the wall
  Vec3 axes_N = Vec3::Zero();  ///< along the normal and two tangents
  Vec3 force_M = Vec3::Zero(); ///< [N]
};

using WirePresses = std::array<WirePress, WireTouch::most>;

/// State of a wire between ticks.
struct WireState
{
  std::uint64_t revision = 0; ///< of the plan
  bool placed = false;
  WirePlaces places_M{};
  double grip_u = 0.0; ///< place of the hand along the sheath where nothing is pushed out
  double led_u = 0.0;  ///< by the hand along the sheath, from there
  Quat hand_W = Quat::Identity();
  double handTurn_rad = 0.0; ///< of the hand about the sheath, turns and all
  double turned_rad = 0.0;   ///< likewise of the outer end
  int pressCount = 0;
  WirePresses presses{};
};

/// Numbers of a wire in a tick, for a person.
struct WireReport
{
  double pushed_u = 0.0;      ///< length of the wire that is out of the sheath, as the outer end has it
  double turned_rad = 0.0;    ///< of the outer end
  double tip_N = 0.0;         ///< force of the wall on the last beam
  double wall_N = 0.0;        ///< the largest force of the wall
  Vec3 wall_W = Vec3::Zero(); ///< where
  int pressCount = 0;         ///< places at which the wall pushes
  int leftOut = 0;            ///< places near the wall for which a tick has no room
  int crowded = 0;            ///< beams with more triangles around them than are looked at
};

/// Result of one tick. M is the frame of the sheath's mouth.
struct WireResult : WireReport
{
  Wrench wrench_W; ///< on the hand, along and about the sheath [N, N u]
  Vec3 tip_W = Vec3::Zero();
  WirePresses presses{};   ///< those that push, in the order of the beams
  double deepest_u = 0.0;  ///< of the wire's skin in the wall, where the tick ends
  double stored_Nu = 0.0;  ///< of the wire and the hand's spring
  double share = 1.0;      ///< of the tick's motion that was proven and taken; below 1 the next tick goes on
  double residual_u = 0.0; ///< of the contacts
  int queries = 0;         ///< of the vessel's tree
  int looked = 0;          ///< at triangles: distances from a beam or a node
  std::uint32_t work = 0;  ///< in the unit of ContactPlan::workBudget
  bool capped = false;     ///< the wire is not at rest yet: the next tick goes on
};

struct WireScratch;

/// A wire in a rigid vessel, at rest in each tick: two Newton steps, each with all contacts as cones of one problem. No
/// axis of a beam goes through the wall: the distance from the wall limits each step. Deterministic,
/// bounded, real-time safe but for making and ending it.
class WireTick
{
public:
  WireTick();
  ~WireTick();
  WireTick(WireTick&&) noexcept;
  WireTick& operator=(WireTick&&) noexcept;

  /// Once a tick. Another plan, by its revision, begins anew, with the tip at the mouth. A hand's pose that is not
  /// finite gives no force.
  [[nodiscard]] const WireResult& step(const WireInput& input) noexcept;

  [[nodiscard]] const WireState& state() const noexcept;
  /// To go on from where a recording begins.
  void restore(const WireState& state) noexcept;

private:
  std::unique_ptr<WireScratch> room_;
};

} // namespace palpate
