// SPDX-License-Identifier: GPL-3.0-or-later
// Row 64: each constraint between two bodies against the statics of finite turns, in hands, turns and tissues at
// random.
#include <algorithm>
#include <optional>

#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/ConstraintTrial.h"

namespace palpate::lab
{
namespace laws_experiment
{

using test::dot;
using test::HeldRod;
using test::Jet;
using test::JetVector;
using Coordinates = ConstraintTrial::Coordinates;

constexpr int ticks = 20; ///< of one trial

/// A constraint's force is counted by the stretch of the hand's spring, so that all coordinates are of one size.
double couplingOf(const ConstraintTrial& trial)
{
  return trial.rig.grip.coupling_N_per_u;
}

void contact(ConstraintTrial& trial)
{
  const Vec3 normal_W = trial.random.direction();
  trial.addTissue(trial.arm_W, normal_W);
  trial.joinTip(ConstraintKind::Contact, "tissue", normal_W);
  const double k = couplingOf(trial);
  for (int i = 0; i < ticks; ++i)
  {
    const Pose hand_W = trial.anyHand(trial.way_u());
    if (normal_W.dot(trial.tipOf(hand_W) - trial.arm_W) >= 0.0)
    {
      trial.expectNothing(hand_W);
      continue;
    }
    const auto law = [&](const HeldRod& rod, const Coordinates& z)
    {
      const Jet force = k * z[6];
      const Jet gap = dot(normal_W, rod.point(z, trial.tip_A) - trial.arm_W);
      return force * gap - 0.5 * trial.yield_u_per_N * force * force;
    };
    trial.expect(hand_W, trial.rest(hand_W, 1, law));
  }
}

/// The tip on a point of the world.
auto pinnedTip(ConstraintTrial& trial)
{
  return [&trial](const HeldRod& rod, const Coordinates& z)
  { return couplingOf(trial) * dot(test::FiniteStatics::vectorOf(z, 6), rod.point(z, trial.tip_A) - trial.arm_W); };
}

void attachment(ConstraintTrial& trial)
{
  trial.joinTip(ConstraintKind::Attachment, "world", Vec3::UnitZ());
  for (int i = 0; i < ticks; ++i)
  {
    const Pose hand_W = trial.anyHand(5e-3);
    trial.expect(hand_W, trial.rest(hand_W, 3, pinnedTip(trial)));
  }
}

/// Pulled from nothing to twice its strength at first, and back.
void breaks(ConstraintTrial& trial)
{
  MechanismConstraint& law = trial.joinTip(ConstraintKind::Break, "world", Vec3::UnitZ());
  const double farthest_u = trial.random.uniform(0.05, 0.2) * trial.length_u;
  const Vec3 way_W = trial.random.direction();
  law.strength_N = 0.5 * farthest_u / trial.yieldAlong(way_W, trial.arm_W);
  bool holds = true;
  for (int i = 0; i < ticks; ++i)
  {
    const double share = i < ticks / 2 ? (i + 0.5) / (ticks / 2) : (ticks - i - 0.5) / (ticks / 2);
    const Pose hand_W{ share * farthest_u * way_W, trial.turn };
    const Eigen::VectorXd& z = trial.rest(hand_W, 3, pinnedTip(trial));
    holds = holds && trial.rodIn(hand_W).force(z).norm() <= law.strength_N;
    holds ? trial.expect(hand_W, z) : trial.expectNothing(hand_W);
  }
}

/// Both axes are brought together, and points or lines.
void axes(ConstraintTrial& trial, ConstraintKind kind)
{
  const Vec3 axis_W = trial.random.direction();
  const Vec3 tilt = trial.random.uniform(0.0, 1e-4) * axis_W.unitOrthogonal();
  MechanismConstraint& law = trial.joinTip(kind, "world", axis_W);
  law.axis_A = trial.turn.conjugate() * (turnBy(tilt) * axis_W);
  law.point_B = trial.arm_W - trial.random.inCube(2e-3);
  const Vec3 first_W = axis_W.unitOrthogonal(), second_W = axis_W.cross(first_W);
  const double k = couplingOf(trial), turning = trial.rig.grip.turning_Nu_per_rad;
  const auto energy = [&](const HeldRod& rod, const Coordinates& z)
  {
    const JetVector axis = rod.direction(z, law.axis_A);
    const JetVector gap = rod.point(z, law.point_A) - law.point_B;
    const Jet along = kind == ConstraintKind::Hinge ? k * (z[10] * dot(axis_W, gap)) : 0.0 * z[0];
    return turning * (z[6] * dot(first_W, axis) + z[7] * dot(second_W, axis)) +
           k * (z[8] * dot(first_W, gap) + z[9] * dot(second_W, gap)) + along;
  };
  for (int i = 0; i < ticks; ++i)
  {
    const Pose hand_W = trial.anyHand(5e-3);
    trial.expect(hand_W, trial.rest(hand_W, kind == ConstraintKind::Hinge ? 5 : 4, energy));
  }
}

void hinge(ConstraintTrial& trial)
{
  axes(trial, ConstraintKind::Hinge);
}

void slider(ConstraintTrial& trial)
{
  axes(trial, ConstraintKind::Slider);
}

/// Pressed along the rod, deeper and less deep, and moved and turned aside: the first time straight, so that where it
/// rests at first is where the hand has it.
void friction(ConstraintTrial& trial)
{
  trial.addTissue(trial.arm_W, -trial.rod_W);
  MechanismConstraint& law = trial.joinTip(ConstraintKind::Friction, "tissue", -trial.rod_W);
  law.friction = trial.random.uniform(0.1, 0.9);
  const double soft = trial.yield_u_per_N, k = couplingOf(trial);
  const double across = trial.yieldAlong(trial.rod_W.unitOrthogonal(), trial.arm_W) + soft;
  // A rod that leans is pushed up by friction as it slides aside. Where that is more than the yield under the push,
  // friction has several answers (it jams); it leans by the friction and by half of the largest turn of the hand.
  const double lever = trial.length_u * trial.length_u / trial.rig.grip.turning_Nu_per_rad;
  const double leans = std::min(0.1, 0.4 * (1.0 / k + soft) / (law.friction * lever));
  const double push_N = std::min(0.5 * trial.safe_N(), 0.5 * leans * trial.length_u / (law.friction * lever));
  const double deepest_u = std::min(4e-3, push_N * (1.0 / k + soft));
  const auto asideOf = [&](const Vec3& v) { return Vec3(v - trial.rod_W.dot(v) * trial.rod_W); };
  Vec3 rests_W = Vec3::Zero(), rubs_N = Vec3::Zero();
  for (int i = 0; i < ticks; ++i)
  {
    const double depth = trial.random.uniform(-0.25, 1.0) * deepest_u;
    Pose hand_W = trial.anyHand(0.02, 0.25 * leans);
    hand_W = i == 0 ? Pose{ Vec3::Zero(), trial.turn } : hand_W;
    hand_W.p += (depth - trial.rod_W.dot(trial.tipOf(hand_W) - trial.arm_W)) * trial.rod_W;
    if (depth <= 0.0)
    {
      rests_W = asideOf(trial.tipOf(hand_W) - trial.arm_W);
      trial.expectNothing(hand_W);
      continue;
    }
    Eigen::VectorXd z;
    const auto under = [&](const Vec3& rubs)
    {
      z = trial.rest(hand_W, 1,
        [&](const HeldRod& rod, const Coordinates& c)
        {
          const JetVector apart = rod.point(c, trial.tip_A) - trial.arm_W;
          const Jet push = k * c[6];
          return push * dot(trial.rod_W, apart) - 0.5 * soft * push * push - dot(rubs, apart);
        });
      const Vec3 slip = asideOf(trial.tipAt(hand_W, z) - trial.arm_W) + soft * rubs - rests_W;
      return test::Rubbed{ slip, law.friction * k * z[6] };
    };
    rubs_N = test::frictionAt(rubs_N, across, under);
    rests_W += under(rubs_N).slip;
    trial.expect(hand_W, z);
  }
}

void dryFriction(ConstraintTrial& trial)
{
  const Vec3 axis_W = trial.random.direction();
  MechanismConstraint& law = trial.joinTip(ConstraintKind::DryFriction, "world", axis_W);
  law.dryFriction_N = std::min(trial.random.uniform(0.1, 1.0), trial.safe_N());
  const double yield = trial.yieldAlong(axis_W, trial.arm_W);
  Vec3 rests_W = Vec3::Zero(), rubs_N = Vec3::Zero();
  for (int i = 0; i < ticks; ++i)
  {
    const Pose hand_W = i == 0 ? Pose{ Vec3::Zero(), trial.turn } : trial.anyHand(0.01);
    Eigen::VectorXd z;
    const auto under = [&](const Vec3& rubs)
    {
      z = trial.rest(hand_W, 0,
        [&](const HeldRod& rod, const Coordinates& c)
        { return -1.0 * dot(rubs, rod.point(c, trial.tip_A) - trial.arm_W); });
      const Vec3 slip = axis_W.dot(trial.tipAt(hand_W, z) - trial.arm_W) * axis_W - rests_W;
      return test::Rubbed{ slip, law.dryFriction_N };
    };
    rubs_N = test::frictionAt(rubs_N, yield, under);
    rests_W += under(rubs_N).slip;
    trial.expect(hand_W, z);
  }
}

/// A spring is a limit on both sides of one place.
void stretched(ConstraintTrial& trial, MechanismConstraint& law, double least_u, double most_u)
{
  law.stiffness_N_per_u = trial.random.uniform(100.0, 3000.0);
  for (int i = 0; i < ticks; ++i)
  {
    const Pose hand_W = trial.anyHand(trial.way_u());
    const double at = law.axis_B.dot(trial.tipOf(hand_W) - trial.arm_W);
    const double stop_u = std::clamp(at, least_u, most_u);
    if (stop_u == at)
    {
      trial.expectNothing(hand_W);
      continue;
    }
    const auto energy = [&](const HeldRod& rod, const Coordinates& z)
    {
      const Jet beyond = dot(law.axis_B, rod.point(z, trial.tip_A) - trial.arm_W) - stop_u;
      return 0.5 * law.stiffness_N_per_u * beyond * beyond;
    };
    trial.expect(hand_W, trial.rest(hand_W, 0, energy));
  }
}

void spring(ConstraintTrial& trial)
{
  MechanismConstraint& law = trial.joinTip(ConstraintKind::Spring, "world", trial.random.direction());
  law.rest_u = trial.random.uniform(-0.4, 0.4) * trial.way_u();
  stretched(trial, law, law.rest_u, law.rest_u);
}

void limit(ConstraintTrial& trial)
{
  MechanismConstraint& law = trial.joinTip(ConstraintKind::Limit, "world", trial.random.direction());
  law.least_u = trial.random.uniform(-0.6, 0.0) * trial.way_u();
  law.most_u = trial.random.uniform(0.0, 0.6) * trial.way_u();
  stretched(trial, law, law.least_u, law.most_u);
}

/// A shaft in a hole of the tissue: it yields across the shaft, and has friction along it.
class InHole
{
public:
  InHole(ConstraintTrial& trial, const Vec3& hole_W, double dryFriction_N)
    : trial_(trial), hole_W_(hole_W), dryFriction_N_(dryFriction_N),
      yield_(trial.yieldAlong(trial.rod_W, trial.arm_W) + trial.yield_u_per_N)
  {
    // Where along the shaft the hole is at first, and the force there.
    this->trial_.beginAt(Eigen::Vector4d(trial.rod_W.dot(hole_W), 0.0, 0.0, 0.0));
  }

  /// How deep the tip has come to rest, from how deep it rested; where there the rod is.
  Eigen::VectorXd at(const Pose& hand_W, double& rests_u)
  {
    Eigen::VectorXd z;
    const auto under = [&](const Vec3& rubs)
    {
      z = this->trial_.rest(
        hand_W, 4, [&](const HeldRod& rod, const Coordinates& c) { return this->energy(rod, c, rubs.x()); });
      return test::Rubbed{ (this->trial_.length_u - z[6] - rests_u) * Vec3::UnitX(), this->dryFriction_N_ };
    };
    this->rubs_N_ = test::frictionAt(this->rubs_N_, this->yield_, under);
    rests_u += under(this->rubs_N_).slip.x();
    return z;
  }

private:
  [[nodiscard]] Jet energy(const HeldRod& rod, const Coordinates& c, double rubs_N) const
  {
    const JetVector force = couplingOf(this->trial_) * test::FiniteStatics::vectorOf(c, 7);
    const JetVector shaft = rod.direction(c, Vec3::UnitZ());
    const JetVector gap = test::FiniteStatics::vectorOf(c, 0) + c[6] * shaft - this->hole_W_;
    return dot(force, gap) - 0.5 * this->trial_.yield_u_per_N * dot(force, force) + rubs_N * c[6];
  }

  ConstraintTrial& trial_;
  Vec3 hole_W_;
  double dryFriction_N_;
  double yield_;
  Vec3 rubs_N_ = Vec3::Zero(); ///< along the shaft, in x
};

/// In and out along the rod: the surface holds until it is punctured where it was met, then the hole has friction, and
/// the rod is moved and turned aside in it, until the tip is out of it.
void puncture(ConstraintTrial& trial)
{
  trial.addTissue(trial.arm_W, -trial.rod_W);
  MechanismConstraint& law = trial.joinTip(ConstraintKind::Puncture, "tissue", Vec3::UnitZ());
  law.strength_N = std::min(trial.random.uniform(0.8, 2.0), trial.safe_N());
  law.dryFriction_N = std::min(trial.random.uniform(0.1, 0.5), 0.5 * law.strength_N);
  const double yield = 1.0 / couplingOf(trial) + trial.yield_u_per_N;
  double depth = -1e-3, rests_u = 0.0;
  std::optional<InHole> hole;
  for (int i = 0; i < 3 * ticks; ++i)
  {
    Pose hand_W{ depth * trial.rod_W, trial.turn };
    if (hole)
    {
      hand_W = trial.anyHand(1e-3);
      hand_W.p += depth * trial.rod_W;
    }
    const double push_N = std::max(depth, 0.0) / yield;
    const Eigen::VectorXd straight = trial.restStraight(hand_W, push_N);
    if (!hole && push_N > law.strength_N)
    {
      hole.emplace(trial, trial.arm_W, law.dryFriction_N);
      rests_u = 0.0;
    }
    const Eigen::VectorXd z = hole ? hole->at(hand_W, rests_u) : straight;
    if (hole && rests_u < 0.0)
    {
      hole.reset();
      trial.expectNothing(hand_W);
      depth = std::min(depth, -1e-3);
      trial.expectNothing({ depth * trial.rod_W, trial.turn }); // from there the tip comes straight again
    }
    else
    {
      trial.expect(hand_W, z);
    }
    depth = std::clamp(depth + trial.random.uniform(-6e-3, 6e-3), -8e-3, 0.04);
  }
}

/// Through a hole: across the shaft as a lever that gets shorter, along it the friction of the hole.
void insertion(ConstraintTrial& trial)
{
  const Vec3 hole_W = trial.random.uniform(0.3, 0.7) * trial.arm_W;
  trial.addTissue(hole_W, -trial.rod_W);
  MechanismConstraint& law = trial.rig.join(ConstraintKind::Insertion, "tissue", Vec3::Zero(), hole_W);
  law.dryFriction_N = trial.random.uniform(0.1, 0.5);
  InHole hole(trial, hole_W, law.dryFriction_N);
  double rests_u = trial.length_u - hole_W.norm();
  for (int i = 0; i < ticks; ++i)
  {
    const Pose hand_W = i == 0 ? Pose{ Vec3::Zero(), trial.turn } : trial.anyHand(5e-3);
    trial.expect(hand_W, hole.at(hand_W, rests_u));
  }
}

constexpr std::pair<ConstraintKind, void (*)(ConstraintTrial&)> laws[] = { { ConstraintKind::Contact, contact },
  { ConstraintKind::Attachment, attachment }, { ConstraintKind::Hinge, hinge }, { ConstraintKind::Slider, slider },
  { ConstraintKind::Break, breaks }, { ConstraintKind::Friction, friction },
  { ConstraintKind::DryFriction, dryFriction }, { ConstraintKind::Spring, spring }, { ConstraintKind::Limit, limit },
  { ConstraintKind::Puncture, puncture }, { ConstraintKind::Insertion, insertion } };

} // namespace laws_experiment

void runConstraints(const Conditions& conditions, Table& table)
{
  using namespace laws_experiment;
  test::Random random(conditions.seed);
  for (const auto& [kind, judge] : laws)
  {
    ConstraintMisses misses;
    for (int i = conditions.pick(20, 100, 2000); i > 0; --i)
    {
      ConstraintTrial trial(random, misses);
      judge(trial);
    }
    const auto subject = [kind](const char* what, const char* unit) {
      return Subject{ nameOf(kind), "ours: all laws in one solve", what, unit };
    };
    table.atMost(subject("force off the statics of finite turns", "N"), misses.force_N, 1e-9).cost =
      Cost::of(misses.cost);
    table.atMost(subject("law missed by", "m"), misses.residual_u, 1e-15);
  }
}

} // namespace palpate::lab
