// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/servo/HandLead.h"

#include <algorithm>
#include <cmath>

#include "haptics/core/PoseMath.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate
{
namespace
{

/// A contact's normal is right to the first order in a turn: beyond, a corner may be elsewhere by a twentieth of its
/// arm (1 - cos .3).
constexpr double mostTurnOfAnswer_rad = 0.3;

/// A displacement is affine in the place: none in a box is larger than the largest one of its corners.
double cornerMotion_u(const PlannedBody& held, const Pose& from_W, const Pose& to_W) noexcept
{
  double most_u = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const Vec3 at((corner & 1u) != 0 ? held.high_u.x() : held.low_u.x(),
      (corner & 2u) != 0 ? held.high_u.y() : held.low_u.y(), (corner & 4u) != 0 ? held.high_u.z() : held.low_u.z());
    most_u = std::max(most_u, (to_W * at - from_W * at).norm());
  }
  return most_u;
}

} // namespace

bool HandLead::isBehind() const noexcept
{
  return this->hand_W.p != this->lead_W.p || this->hand_W.q.coeffs() != this->lead_W.q.coeffs();
}

double reachTaken(const FoundContacts& found, const PlannedBody& held, const Pose& held_W) noexcept
{
  if (found.answer == 0 || std::isinf(found.reach_u))
  {
    return 0.0;
  }
  const double turn_rad = found.count > 0 ? turnFromTo(found.held_W.q, held_W.q).norm() : 0.0;
  return std::max(cornerMotion_u(held, found.held_W, held_W) / found.reach_u, turn_rad / mostTurnOfAnswer_rad);
}

Pose followed(const HandLead& before, const Pose& hand_W, double share) noexcept
{
  if (!before.isBehind() || share >= 1.0)
  {
    return hand_W;
  }
  const Vec3 way_u = before.lead_W.p - before.hand_W.p, turn_rad = turnFromTo(before.hand_W.q, before.lead_W.q);
  return { hand_W.p + (1.0 - share) * way_u, (turnBy((1.0 - share) * turn_rad) * hand_W.q).normalized() };
}

double behind_u(const HandLead& before, double arm_u) noexcept
{
  const double turn_rad = turnFromTo(before.hand_W.q, before.lead_W.q).norm();
  return std::hypot((before.lead_W.p - before.hand_W.p).norm(), arm_u * turn_rad);
}

Pose partOfWay(const Pose& from_W, const Pose& to_W, double share) noexcept
{
  const Vec3 turn_rad = turnFromTo(from_W.q, to_W.q);
  return { from_W.p + share * (to_W.p - from_W.p), (turnBy(share * turn_rad) * from_W.q).normalized() };
}

} // namespace palpate
