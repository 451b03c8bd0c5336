// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "LooseRig.h"
#include "haptics/tool/motion/Turn.h"

/// Loose bodies of which mechanics knows the answer, for tests and experiments.
namespace palpate::test
{

inline constexpr double tickOfPath_s = 1e-3;
inline const Vec3 stoneHalf_m(0.03, 0.02, 0.01);

/// Of a box of stone.
inline double boxMass_kg(const Vec3& half_m)
{
  return stone_kg_per_m3 * 8.0 * half_m.prod();
}

inline Quat turnedBy(double angle_rad, const Vec3& axis)
{
  return Quat(Eigen::AngleAxisd(angle_rad, axis.normalized()));
}

/// How far a box goes down a slope in a second.
inline double slid_m(double tilt_rad, double friction)
{
  const Quat slope = turnedBy(tilt_rad, Vec3::UnitY());
  LooseRig rig(friction, slope);
  rig.add(stoneHalf_m, Vec3(0, 0, stoneHalf_m.z()));
  LooseRun run(rig.inputs);
  (void)run.rest(1.0);
  return (slope.conjugate() * run.pose_W(LooseRig::first).p).x();
}

/// Three boxes on one another, each smaller than the one below.
struct Stack
{
  static constexpr double friction = 0.5;
  std::array<Vec3, 3> half_m{ Vec3(0.04, 0.03, 0.02), Vec3(0.03, 0.03, 0.015), Vec3(0.015, 0.03, 0.045) };

  [[nodiscard]] double weight_N(int from) const
  {
    double volume = 0.0;
    for (int k = from; k < 3; ++k)
    {
      volume += 8.0 * this->half_m[static_cast<std::size_t>(k)].prod();
    }
    return stone_kg_per_m3 * volume * gravity_m_per_s2;
  }
  [[nodiscard]] double below_m(int k) const
  {
    double z = 0.0;
    for (int i = 0; i < k; ++i)
    {
      z += 2.0 * this->half_m[static_cast<std::size_t>(i)].z();
    }
    return z;
  }
  /// The boxes from k on, as one, slide on the one below or tip about their front edge.
  struct Limit
  {
    double force_N = std::numeric_limits<double>::infinity();
    bool tips = false;
    int from = 0;
  };
  [[nodiscard]] Limit limitOf(int pushed) const
  {
    Limit least;
    const double height_m = this->below_m(pushed) + this->half_m[static_cast<std::size_t>(pushed)].z();
    for (int k = 0; k <= pushed; ++k)
    {
      const double tip_N =
        this->weight_N(k) * this->half_m[static_cast<std::size_t>(k)].x() / (height_m - this->below_m(k));
      const double slide_N = friction * this->weight_N(k);
      const Limit here{ std::min(tip_N, slide_N), tip_N < slide_N, k };
      least = here.force_N < least.force_N ? here : least;
    }
    return least;
  }
};

/// How far the boxes of a stack have gone and turned after .6 s, one of them pushed by a share of its limit.
struct StackMotion
{
  double most_m = 0.0; ///< of any
  double turned_rad = 0.0;
  std::array<double, 3> along_m{};
};
inline StackMotion pushStack(int pushed, double share)
{
  const Stack stack;
  LooseRig rig(Stack::friction);
  for (int k = 0; k < 3; ++k)
  {
    const Vec3& half = stack.half_m[static_cast<std::size_t>(k)];
    MechanismBody& body = rig.add(half, Vec3(0, 0, stack.below_m(k) + half.z()));
    body.load_W.x() = k == pushed ? share * stack.limitOf(pushed).force_N : 0.0;
  }
  LooseRun run(rig.inputs);
  (void)run.rest(0.6);
  StackMotion motion;
  for (int k = 0; k < 3; ++k)
  {
    const Pose& now_W = run.pose_W(LooseRig::first + k);
    motion.most_m = std::max(motion.most_m, now_W.p.head<2>().norm());
    motion.turned_rad = std::max(motion.turned_rad, turnFromTo(Quat::Identity(), now_W.q).norm());
    motion.along_m[static_cast<std::size_t>(k)] = now_W.p.x();
  }
  return motion;
}

/// A box on the hand's spring and on one of its own, without weight.
class Coupled
{
public:
  Coupled(double hand_N_per_m, double own_N_per_m)
  {
    LooseRig rig(0.0);
    MechanismBody& body = rig.add(Vec3::Constant(0.02), Vec3(0, 0, 0.3));
    body.load_W.setZero();
    MechanismConstraint grip, spring;
    grip.name = "grip";
    grip.kind = ConstraintKind::Attachment;
    grip.a = "hand";
    grip.b = "box 0";
    spring.name = "spring";
    spring.kind = ConstraintKind::Spring;
    spring.a = "box 0";
    spring.b = "table";
    spring.point_B = Vec3(0, 0, 0.3);
    spring.axis_B = Vec3::UnitX();
    spring.stiffness_N_per_u = own_N_per_m;
    rig.meetNothing({ grip, spring });
    MechanismHold hold = firmHold();
    hold.stiffness_N_per_m = hand_N_per_m;
    this->run_ = std::make_unique<LooseRun>(rig.inputs, tickOfPath_s, hold);
  }

  double next(double hand_m)
  {
    (void)this->run_->next(Vec3(hand_m, 0, 0.3));
    return this->run_->pose_W(LooseRig::first).p.x();
  }
  [[nodiscard]] double mass_kg() const
  {
    return this->run_->touch().plan().bodies[LooseRig::first].mass.mass_Ns2_per_u;
  }

private:
  std::unique_ptr<LooseRun> run_;
};

/// Whether the same box diverges where it is pushed by the forces of the tick before.
inline bool explodes(double mass_kg, double hand_N_per_m, double own_N_per_m)
{
  double x = 1e-3, v = 0.0;
  for (int i = 0; i < 20000 && std::abs(x) < 1.0; ++i)
  {
    v -= tickOfPath_s / mass_kg * (hand_N_per_m + own_N_per_m) * x;
    x += tickOfPath_s * v;
  }
  return std::abs(x) >= 1.0;
}

/// A box that hangs from a point of the world by an arm.
struct Swung
{
  static constexpr double arm_m = 0.05;
  double angle_rad = 0.0; ///< below the horizontal
  double away_m = 0.0;    ///< of its centre from that point
};

/// Let go with a horizontal arm, after a time.
inline Swung swung(double tick_s, double until_s)
{
  constexpr double arm_m = Swung::arm_m;
  LooseRig rig(0.0);
  rig.add(Vec3::Constant(0.02), Vec3(arm_m, 0, 0.5));
  MechanismBody& body = rig.inputs.mechanism.bodies.back();
  body.halfSize_u = Vec3::Constant(arm_m); // so that the pin lies in the box; the mass is that of the small one
  MechanismConstraint pin;
  pin.name = "pin";
  pin.kind = ConstraintKind::Attachment;
  pin.a = "box 0";
  pin.b = "table";
  pin.point_A = Vec3(-arm_m, 0, 0);
  pin.point_B = Vec3(0, 0, 0.5);
  rig.meetNothing({ pin });
  LooseRun run(rig.inputs, tick_s);
  (void)run.next(); // of a millisecond, as the first tick of a path is
  (void)run.rest(until_s - 1e-3);
  const Vec3 way = run.pose_W(LooseRig::first).p - pin.point_B;
  return { std::atan2(-way.z(), way.x()), way.norm() };
}

/// The same by small steps of a pendulum: I a'' = m g l cos a, from the horizontal.
inline double pendulum_rad(double until_s)
{
  const double half = 0.02, arm = Swung::arm_m;
  const double perMass = 2.0 / 3.0 * half * half + arm * arm;
  const auto spinUp = [&](double a) { return gravity_m_per_s2 * arm * std::cos(a) / perMass; };
  constexpr int steps = 200000;
  const double h = until_s / steps;
  double a = 0.0, w = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double middle = w + 0.5 * h * spinUp(a);
    a += h * middle;
    w = middle + 0.5 * h * spinUp(a);
  }
  return a;
}

} // namespace palpate::test
