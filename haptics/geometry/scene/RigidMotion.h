// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// How a surface moves from one snapshot of the scene to the next: poses of its frame S in W [u].
struct RigidMotion
{
  Pose begin_WS;
  Pose end_WS;

  /// False for poses that are not finite or whose quaternion is not a unit one.
  [[nodiscard]] bool isRigid() const noexcept
  {
    for (const Pose* const pose : { &this->begin_WS, &this->end_WS })
    {
      const double off = pose->q.coeffs().squaredNorm() - 1.0;
      if (!pose->p.allFinite() || !(off > -1e-6 && off < 1e-6))
      {
        return false;
      }
    }
    return true;
  }
  [[nodiscard]] bool moves() const noexcept
  {
    return this->begin_WS.p != this->end_WS.p || this->begin_WS.q.coeffs() != this->end_WS.q.coeffs();
  }
  /// True if the surface lies in W as its vertices say, and stays there.
  [[nodiscard]] bool isStill() const noexcept
  {
    return !this->moves() && this->end_WS.p == Vec3::Zero() && this->end_WS.q.coeffs() == Quat::Identity().coeffs();
  }
  /// Pose at a share 0..1 of the motion. Rotations are interpolated by their normalised mean: the angle differs from an
  /// even turn by less than its cube / 100 and needs no sine.
  [[nodiscard]] Pose at(double share) const noexcept
  {
    if (share >= 1.0 || !this->moves())
    {
      return this->end_WS;
    }
    const double sign = this->begin_WS.q.dot(this->end_WS.q) < 0.0 ? -1.0 : 1.0;
    Pose pose;
    pose.p = this->begin_WS.p + share * (this->end_WS.p - this->begin_WS.p);
    pose.q.coeffs() = (1.0 - share) * this->begin_WS.q.coeffs() + share * sign * this->end_WS.q.coeffs();
    pose.q.normalize();
    return pose;
  }
};

} // namespace palpate
