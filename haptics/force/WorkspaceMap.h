// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "haptics/core/Types.h"

namespace palpate
{

/// Where the device's workspace D lies in the scene W: p_W = offset_W + scale * (q_WD p_D).
struct WorkspaceMap
{
  double scale_u_per_m = 1.0;
  Quat q_WD = Quat::Identity();
  Vec3 offset_W = Vec3::Zero(); ///< the device's origin [u]

  [[nodiscard]] Vec3 toScene(const Vec3& p_D) const noexcept
  {
    return this->offset_W + this->scale_u_per_m * (this->q_WD * p_D);
  }
  [[nodiscard]] Vec3 toDevice(const Vec3& p_W) const noexcept
  {
    return this->q_WD.conjugate() * ((p_W - this->offset_W) / this->scale_u_per_m);
  }
  [[nodiscard]] Vec3 directionToScene(const Vec3& v_D) const noexcept { return this->q_WD * v_D; }
  [[nodiscard]] Vec3 directionToDevice(const Vec3& v_W) const noexcept { return this->q_WD.conjugate() * v_W; }
};

/// Whether a hand that another map has put from one place to the other went no further than a brisk hand does in ten
/// ticks: then surfaces hold it back as on any other motion. Further away it is elsewhere: the gap was not passed.
[[nodiscard]] inline bool isNearby(const WorkspaceMap& map, const Vec3& before_W, const Vec3& now_W) noexcept
{
  constexpr double nearby_m = 0.005;
  return (now_W - before_W).norm() <= nearby_m * map.scale_u_per_m;
}

/// The same, bit for bit.
[[nodiscard]] inline bool isSame(const WorkspaceMap& a, const WorkspaceMap& b) noexcept
{
  return a.scale_u_per_m == b.scale_u_per_m && a.q_WD.coeffs() == b.q_WD.coeffs() && a.offset_W == b.offset_W;
}

} // namespace palpate
