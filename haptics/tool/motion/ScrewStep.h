// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tool/motion/Turn.h"

namespace palpate
{

/// A small motion of the tool from a pose: its centre moves by v on a straight line while it rotates by w about
/// its centre, both at constant speed. At a share s of it: centre + s v, rotated by exp(s w).
struct ScrewStep
{
  Pose from_W;
  Vec3 v_W = Vec3::Zero(); ///< [u]
  Vec3 w_W = Vec3::Zero(); ///< [rad]

  [[nodiscard]] Mat3 turn(double share) const noexcept { return turnBy(share * this->w_W).toRotationMatrix(); }
  [[nodiscard]] Vec3 centre_W(double share) const noexcept { return this->from_W.p + share * this->v_W; }
  /// Upper bound of the displacement of any point of a tool of this reach [u].
  [[nodiscard]] double displacement_u(double reach_u) const noexcept
  {
    return this->v_W.norm() + this->w_W.norm() * reach_u;
  }
  [[nodiscard]] Pose end_W(double share) const noexcept
  {
    Pose end{ this->centre_W(share), turnBy(share * this->w_W) * this->from_W.q };
    end.q.normalize();
    return end;
  }
};

} // namespace palpate
