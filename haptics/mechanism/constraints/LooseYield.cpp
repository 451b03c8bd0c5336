// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/constraints/LooseYield.h"

#include "haptics/core/CrossMatrix.h"

namespace palpate
{
namespace
{

/// Newton's steps of the gyroscopic moments: a body turns by little in a tick, and two steps leave rounding.
constexpr int gyroSteps = 3;
/// Of the lever in a second: a body that goes no faster for so long sleeps.
constexpr double calmBelow = 1e-3, calmFor_s = 0.1;
/// Of the acceleration by its load: a body that is moved by no more in a tick from rest goes on sleeping.
constexpr double wokenBy = 1e-3;
/// A turn in a tick beyond which the rows of small turns mean little [rad].
constexpr double mostTurn_rad = 0.25;

/// I (w - spin) + dt w x I w = 0: the energy w I w does not grow, as w is normal to w x I w.
Vec3 freeSpin(const Mat3& inertia, const Vec3& spin_B, double dt_s) noexcept
{
  Vec3 w = spin_B;
  for (int step = 0; step < gyroSteps && spin_B != Vec3::Zero(); ++step)
  {
    const Vec3 open = inertia * (w - spin_B) + dt_s * w.cross(inertia * w);
    const Mat3 slope = inertia + dt_s * (crossMatrix(w) * inertia - crossMatrix(inertia * w));
    w -= slope.inverse() * open;
  }
  return w;
}

} // namespace

LooseYield yieldOfLoose(
  const PlannedBody& body, const Quat& q_W, const LooseMotion& motion, double characteristic_u, double dt_s) noexcept
{
  LooseYield yield;
  if (motion.lost)
  {
    return yield;
  }
  const Mat3 r = q_W.toRotationMatrix();
  const double perMass = dt_s * dt_s / body.mass.mass_Ns2_per_u;
  yield.compliance.topLeftCorner<3, 3>() = perMass * Mat3::Identity();
  const Mat3 turns =
    dt_s * dt_s * characteristic_u * characteristic_u * (r * body.mass.inertia_N_s2_u.inverse() * r.transpose());
  yield.compliance.bottomRightCorner<3, 3>() = 0.5 * (turns + turns.transpose());
  const Vec3 spin_B = freeSpin(body.mass.inertia_N_s2_u, motion.spin_B, dt_s);
  yield.back_u.head<3>() = dt_s * motion.speed_W + perMass * body.load_W;
  yield.back_u.tail<3>() = dt_s * characteristic_u * (r * spin_B);
  return yield;
}

LooseMotion motionAfter(const MechanismPlan& plan, const PlannedBody& body, const LooseMotion& before,
  const LooseStep& step, double dt_s) noexcept
{
  LooseMotion after = before;
  after.lost = before.lost || step.away_u > plan.farthest_u;
  const double way_u = step.way_u.norm();
  const double woken_u = wokenBy * dt_s * dt_s * body.load_W.norm() / body.mass.mass_Ns2_per_u;
  after.asleep = after.lost || (before.asleep && way_u <= woken_u);
  if (after.asleep)
  {
    after.speed_W = after.spin_B = Vec3::Zero();
    return after;
  }
  const Vec3 turn_rad = step.way_u.tail<3>() / plan.characteristic_u;
  const double share = mostTurn_rad / std::max(mostTurn_rad, turn_rad.norm());
  after.speed_W = step.way_u.head<3>() / dt_s;
  after.spin_B = share / dt_s * (step.q_W.conjugate() * turn_rad);
  after.calm_s = way_u <= calmBelow * plan.characteristic_u * dt_s ? before.calm_s + dt_s : 0.0;
  after.asleep = after.calm_s > calmFor_s;
  after.calm_s = after.asleep ? 0.0 : after.calm_s;
  after.speed_W = after.asleep ? Vec3(Vec3::Zero()) : after.speed_W;
  after.spin_B = after.asleep ? Vec3(Vec3::Zero()) : after.spin_B;
  return after;
}

} // namespace palpate
