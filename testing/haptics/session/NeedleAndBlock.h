// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "SoftBlock.h"
#include "haptics/mechanism/servo/FeltMechanism.h"
#include "haptics/session/mechanism/MechanismBodies.h"

namespace palpate::test
{

inline constexpr double handSpring = 1000.0, handTurning = 2.0; // N/m, N m/rad
inline constexpr double needleLength = 0.1;
inline constexpr double punctureAt_N = 1.5, shaftFriction_N = 0.4;

/// Where the needle meets the block: within one triangle of its top.
inline Vec3 placeOnTop()
{
  return topOfBlock() + Vec3(2e-3, 1e-3, 0);
}

/// Points down, its tip so far from there.
inline Pose needleAt(const Vec3& tipFromTop)
{
  return { placeOnTop() + tipFromTop + Vec3(0, 0, needleLength), Quat(0, 1, 0, 0) };
}

inline MechanismBody bodyOf(const char* name, MechanismBodyKind kind)
{
  MechanismBody body;
  body.name = name;
  body.kind = kind;
  body.length_u = needleLength;
  body.diameter_u = 1e-3;
  return body;
}

/// A needle and the block of 20 kPa, which it goes into at 1.5 N.
inline MechanismInputs needleAndBlock(ElasticModel model = ElasticModel::Linear)
{
  MechanismInputs inputs;
  inputs.mechanism.bodies = { bodyOf("needle", MechanismBodyKind::Held), bodyOf("block", MechanismBodyKind::Soft) };
  MechanismConstraint puncture;
  puncture.name = "puncture";
  puncture.kind = ConstraintKind::Puncture;
  puncture.a = "needle";
  puncture.b = "block";
  puncture.strength_N = punctureAt_N;
  puncture.dryFriction_N = shaftFriction_N;
  inputs.mechanism.laws = { puncture };
  inputs.soft = { { "block", std::make_shared<const SoftBodyInput>(softBlock(model)) } };
  return inputs;
}

/// The same, as the servo takes it at rest.
inline std::shared_ptr<const FeltMechanism> feltBlock()
{
  const MechanismInputs inputs = needleAndBlock();
  std::string refusal;
  const auto bodies = MechanismBodies::make(inputs.soft, refusal);
  const MechanismPlan plan = planMechanism(inputs.mechanism, bodies->atRest(), 1);
  return std::make_shared<const FeltMechanism>(1, plan, bodies->newest());
}

/// A needle whose tip is held where it is when the hand is at needleAt(0).
inline MechanismInputs tipHeld()
{
  MechanismInputs inputs;
  inputs.mechanism.bodies = { bodyOf("needle", MechanismBodyKind::Held), bodyOf("world", MechanismBodyKind::World) };
  MechanismConstraint held;
  held.name = "tip";
  held.kind = ConstraintKind::Attachment;
  held.a = "needle";
  held.b = "world";
  held.point_A = Vec3(0, 0, needleLength);
  held.point_B = placeOnTop();
  inputs.mechanism.laws = { held };
  return inputs;
}

} // namespace palpate::test
