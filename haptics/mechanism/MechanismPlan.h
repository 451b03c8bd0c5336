// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "haptics/compliance/snapshot/ComplianceSnapshot.h"
#include "haptics/mechanism/Mechanism.h"

namespace palpate
{

/// A body as the tick knows it.
struct PlannedBody
{
  MechanismBodyKind kind = MechanismBodyKind::World;
  int soft = -1; ///< a soft one's place among those that the tick is given
  double length_u = 0.0;
  Pose pose_W;
  Vec3 load_W = Vec3::Zero();
  BodyMass mass;             ///< of a rigid one that is loose
  Vec3 low_u = Vec3::Zero(); ///< bounds of its mesh, in its frame
  Vec3 high_u = Vec3::Zero();
};

/// A constraint as the tick knows it: numbers in place of names.
struct PlannedConstraint
{
  ConstraintKind kind = ConstraintKind::Contact;
  int a = 0;
  int b = 0;
  Vec3 point_A = Vec3::Zero();
  Vec3 point_B = Vec3::Zero();
  Vec3 axis_A = Vec3::UnitZ();
  Vec3 axis_B = Vec3::UnitZ();
  double strength_N = MechanismConstraint::unlimited;
  double tear_N = MechanismConstraint::unlimited;
  double friction = 0.0;
  double dryFriction_N = 0.0;
  double compliance_u_per_N = 0.0;
  double rest_u = 0.0;
  double least_u = -MechanismConstraint::unlimited;
  double most_u = MechanismConstraint::unlimited;
  SurfacePoint place_A; ///< point_A in a soft body's surface
  SurfacePoint place_B; ///< likewise
};

struct WirePlan;

/// The plan of the tick. Immutable; of fixed size but for a wire, which its copies share.
struct MechanismPlan
{
  std::uint64_t revision = 0;                         ///< another for each that is handed on; above 0
  double characteristic_u = 1.0;                      ///< rotations are measured by the displacement of its end
  double farthest_u = MechanismConstraint::unlimited; ///< so far a loose body goes from where it began, then it sleeps
  int bodyCount = 0;
  int lawCount = 0;
  int held = -1; ///< which body is in the hand; -1: none
  std::array<PlannedBody, Mechanism::mostBodies> bodies{};
  std::array<PlannedConstraint, Mechanism::mostConstraints> laws{};
  std::shared_ptr<const WirePlan> wire; ///< of the body in the hand; null: that is none
};

/// Pose of the held body in the hand; the body may rotate in the hand.
[[nodiscard]] inline Pose heldBy(const Pose& hand_W, const MechanismPlan& plan) noexcept
{
  return plan.held >= 0 ? Pose{ hand_W.p, hand_W.q * plan.bodies[plan.held].pose_W.q } : hand_W;
}

} // namespace palpate
