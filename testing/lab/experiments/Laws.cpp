// SPDX-License-Identifier: GPL-3.0-or-later
// Row 64: each law between two bodies against its closed form, in hands, turns and tissues at random.
#include <algorithm>

#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/LawTrial.h"

namespace palpate::lab
{
namespace laws_experiment
{

constexpr int ticks = 20; ///< of one trial

void contact(LawTrial& trial)
{
  const Vec3 normal_W = trial.random.direction();
  trial.addTissue(trial.arm_W, normal_W);
  trial.joinTip(LawKind::Contact, "tissue", normal_W);
  const double yield = trial.yieldAlong(normal_W, trial.arm_W) + trial.yield_u_per_N;
  for (int i = 0; i < ticks; ++i)
  {
    const Vec3 hand_W = trial.random.inCube(5e-3);
    trial.expectAtTip(hand_W, std::max(-normal_W.dot(hand_W), 0.0) / yield * normal_W);
  }
}

/// Along the rod the hand's spring alone, across it the turn in series.
Vec3 heldPoint_N(const LawTrial& trial, const Vec3& hand_W)
{
  const Vec3 along_W = trial.rod_W.dot(hand_W) * trial.rod_W;
  const double across = trial.yieldAlong(trial.rod_W.unitOrthogonal(), trial.arm_W);
  return -trial.rig.grip.coupling_N_per_u * along_W - (hand_W - along_W) / across;
}

void attachment(LawTrial& trial)
{
  trial.joinTip(LawKind::Attachment, "world", Vec3::UnitZ());
  for (int i = 0; i < ticks; ++i)
  {
    const Vec3 hand_W = trial.random.inCube(5e-3);
    trial.expectAtTip(hand_W, heldPoint_N(trial, hand_W));
  }
}

/// Pulled from nothing to twice what it holds, and back.
void breaks(LawTrial& trial)
{
  MechanismLaw& law = trial.joinTip(LawKind::Break, "world", Vec3::UnitZ());
  law.strength_N = trial.random.uniform(0.5, 3.0);
  const Vec3 way_W = trial.random.direction();
  const Vec3 farthest_W = 2.0 * law.strength_N / heldPoint_N(trial, way_W).norm() * way_W;
  for (int i = 0; i < ticks; ++i)
  {
    const double share = i < ticks / 2 ? (i + 0.5) / (ticks / 2) : (ticks - i - 0.5) / (ticks / 2);
    const bool holds = i < ticks / 4;
    const Vec3 hand_W = share * farthest_W;
    trial.expectAtTip(hand_W, holds ? heldPoint_N(trial, hand_W) : Vec3(Vec3::Zero()));
  }
}

/// Both axes are brought together, and points or lines. How far the rod turns about the axis is where the energy of the
/// hand's spring is least, k |e + turn b|^2 + turning turn^2.
void axes(LawTrial& trial, LawKind kind)
{
  const Vec3 axis_W = trial.random.direction();
  const Vec3 tilt = trial.random.uniform(0.0, 1e-7) * axis_W.unitOrthogonal(); // its square is below rounding
  const Vec3 apart_W = trial.random.inCube(2e-3);
  MechanismLaw& law = trial.joinTip(kind, "world", axis_W);
  law.axis_A = trial.turn.conjugate() * (turnBy(tilt) * axis_W);
  law.point_B = trial.arm_W - apart_W;
  Vec3 e_W = apart_W - tilt.cross(trial.arm_W);
  if (kind == LawKind::Slider)
  {
    e_W -= axis_W.dot(e_W) * axis_W;
  }
  const auto& [k, turning] = trial.rig.grip;
  const Vec3 b_W = axis_W.cross(trial.arm_W);
  const double turn = -k * e_W.dot(b_W) / (k * b_W.squaredNorm() + turning);
  trial.expect(Vec3::Zero(), { -k * (e_W + turn * b_W), turning * (turn * axis_W - tilt) });
}

void hinge(LawTrial& trial)
{
  axes(trial, LawKind::Hinge);
}

void slider(LawTrial& trial)
{
  axes(trial, LawKind::Slider);
}

/// Pressed straight along the rod, deeper and less deep, and moved across.
void friction(LawTrial& trial)
{
  trial.addTissue(trial.arm_W, -trial.rod_W);
  MechanismLaw& law = trial.joinTip(LawKind::Friction, "tissue", -trial.rod_W);
  law.friction = trial.random.uniform(0.1, 0.9);
  const double along = trial.yieldAlong(trial.rod_W, trial.arm_W) + trial.yield_u_per_N;
  const double across = trial.yieldAlong(trial.rod_W.unitOrthogonal(), trial.arm_W) + trial.yield_u_per_N;
  Vec3 rest_W;
  for (int i = 0; i < ticks; ++i)
  {
    const double depth = trial.random.uniform(-1e-3, 4e-3);
    Vec3 aside_W = trial.random.inCube(0.02);
    aside_W -= trial.rod_W.dot(aside_W) * trial.rod_W;
    rest_W = i == 0 ? aside_W : rest_W;
    const double push = std::max(depth, 0.0) / along;
    const Vec3 rubs_W = rub(aside_W, across, law.friction * push, rest_W);
    trial.expectAtTip(aside_W + depth * trial.rod_W, rubs_W - push * trial.rod_W);
  }
}

void dryFriction(LawTrial& trial)
{
  const Vec3 axis_W = trial.random.direction();
  MechanismLaw& law = trial.joinTip(LawKind::DryFriction, "world", axis_W);
  law.dryFriction_N = trial.random.uniform(0.1, 1.0);
  const double yield = trial.yieldAlong(axis_W, trial.arm_W);
  Vec3 rest_W;
  for (int i = 0; i < ticks; ++i)
  {
    const Vec3 hand_W = trial.random.inCube(0.01);
    const Vec3 along_W = axis_W.dot(hand_W) * axis_W;
    rest_W = i == 0 ? along_W : rest_W;
    trial.expectAtTip(hand_W, rub(along_W, yield, law.dryFriction_N, rest_W));
  }
}

/// A spring is a limit on both sides of one place.
void stretched(LawTrial& trial, MechanismLaw& law, double least_u, double most_u)
{
  law.stiffness_N_per_u = trial.random.uniform(100.0, 3000.0);
  const double yield = trial.yieldAlong(law.axis_B, trial.arm_W) + 1.0 / law.stiffness_N_per_u;
  for (int i = 0; i < ticks; ++i)
  {
    const Vec3 hand_W = trial.random.inCube(5e-3);
    const double at = law.axis_B.dot(hand_W);
    trial.expectAtTip(hand_W, (std::clamp(at, least_u, most_u) - at) / yield * law.axis_B);
  }
}

void spring(LawTrial& trial)
{
  MechanismLaw& law = trial.joinTip(LawKind::Spring, "world", trial.random.direction());
  law.rest_u = trial.random.uniform(-2e-3, 2e-3);
  stretched(trial, law, law.rest_u, law.rest_u);
}

void limit(LawTrial& trial)
{
  MechanismLaw& law = trial.joinTip(LawKind::Limit, "world", trial.random.direction());
  law.least_u = trial.random.uniform(-3e-3, 0.0);
  law.most_u = trial.random.uniform(0.0, 3e-3);
  stretched(trial, law, law.least_u, law.most_u);
}

/// In and out along the rod: the surface holds until it is punctured, then the hole rubs, until the tip is out of it.
void puncture(LawTrial& trial)
{
  trial.addTissue(trial.arm_W, -trial.rod_W);
  MechanismLaw& law = trial.joinTip(LawKind::Puncture, "tissue", Vec3::UnitZ());
  law.strength_N = trial.random.uniform(0.8, 2.0);
  law.dryFriction_N = trial.random.uniform(0.1, 0.5);
  const double yield = trial.yieldAlong(trial.rod_W, trial.arm_W) + trial.yield_u_per_N;
  double depth = -1e-3;
  bool inside = false;
  Vec3 rest_W;
  for (int i = 0; i < 5 * ticks; ++i)
  {
    const Vec3 hand_W = depth * trial.rod_W;
    Vec3 force_W = -std::max(depth, 0.0) / yield * trial.rod_W;
    if (!inside && force_W.norm() > law.strength_N)
    {
      inside = true;
      rest_W.setZero();
    }
    force_W = inside ? rub(hand_W, yield, law.dryFriction_N, rest_W) : force_W;
    if (inside && trial.rod_W.dot(rest_W) < 0.0)
    {
      inside = false;
      force_W.setZero();
    }
    trial.expectAtTip(hand_W, force_W);
    depth = std::clamp(depth + trial.random.uniform(-6e-3, 6e-3), -8e-3, 0.04);
  }
}

/// Through a hole: across the shaft as a lever that gets shorter, along it what the hole rubs.
void insertion(LawTrial& trial)
{
  const double hole_u = trial.random.uniform(0.3, 0.7) * trial.length_u;
  trial.addTissue(hole_u * trial.rod_W, -trial.rod_W);
  MechanismLaw& law = trial.rig.join(LawKind::Insertion, "tissue", Vec3::Zero(), hole_u * trial.rod_W);
  law.dryFriction_N = trial.random.uniform(0.1, 0.5);
  const double along = trial.yieldAlong(trial.rod_W, trial.arm_W) + trial.yield_u_per_N;
  Vec3 rest_W;
  for (int i = 0; i < ticks; ++i)
  {
    const Vec3 hand_W = trial.random.inCube(5e-3);
    const Vec3 along_W = trial.rod_W.dot(hand_W) * trial.rod_W;
    rest_W = i == 0 ? along_W : rest_W;
    const Vec3 lever_W = hole_u * trial.rod_W - along_W;
    const double across = trial.yieldAlong(trial.rod_W.unitOrthogonal(), lever_W) + trial.yield_u_per_N;
    const Vec3 force_W = rub(along_W, along, law.dryFriction_N, rest_W) - (hand_W - along_W) / across;
    trial.expect(hand_W, { force_W, lever_W.cross(force_W) });
  }
}

constexpr std::pair<LawKind, void (*)(LawTrial&)> laws[] = { { LawKind::Contact, contact },
  { LawKind::Attachment, attachment }, { LawKind::Hinge, hinge }, { LawKind::Slider, slider },
  { LawKind::Break, breaks }, { LawKind::Friction, friction }, { LawKind::DryFriction, dryFriction },
  { LawKind::Spring, spring }, { LawKind::Limit, limit }, { LawKind::Puncture, puncture },
  { LawKind::Insertion, insertion } };

} // namespace laws_experiment

void runLaws(const Conditions& conditions, Table& table)
{
  using namespace laws_experiment;
  test::Random random(conditions.seed);
  for (const auto& [kind, judge] : laws)
  {
    LawMisses misses;
    for (int i = conditions.pick(20, 100, 2000); i > 0; --i)
    {
      LawTrial trial(random, misses);
      judge(trial);
    }
    const auto subject = [kind](const char* what, const char* unit) {
      return Subject{ nameOf(kind), "ours: all laws in one solve", what, unit };
    };
    table.atMost(subject("force off its closed form", "N"), misses.force_N, 1e-9).cost = Cost::of(misses.cost);
    table.atMost(subject("law missed by", "m"), misses.residual_u, 1e-15);
  }
}

} // namespace palpate::lab
