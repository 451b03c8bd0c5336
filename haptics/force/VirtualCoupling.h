// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "haptics/core/Types.h"

namespace palpate
{

/// The spring and damper between device and god-object (Colgate, Stanley & Brown 1995).
///
/// `stretch_m` is proxy - device [m], `velocity` that of the device [m/s]; all in one frame. The damper acts along
/// the spring, F = max(0, K s + B v_in): the whole never pulls the hand in, the clamp comes after adding damping.
/// Returns the force on the hand [N]. Of six numbers the last three are turns times a lever [m], and a torque over it.
template<class Vector>
[[nodiscard]] Vector coupleAlong(
  const Vector& stretch_m, const Vector& velocity, double stiffness_N_per_m, double damping_Ns_per_m) noexcept
{
  const Vector spring = stiffness_N_per_m * stretch_m;
  const double stretch = stretch_m.norm();
  if (damping_Ns_per_m == 0.0 || stretch == 0.0)
  {
    return spring;
  }
  const Vector n = stretch_m / stretch;
  const double damper = -damping_Ns_per_m * n.dot(velocity);
  return std::max(-stiffness_N_per_m * stretch, damper) * n + spring;
}

/// The same of a hand that is a point.
[[nodiscard]] inline Vec3 coupleDevice(
  const Vec3& stretch_m, const Vec3& velocity, double stiffness_N_per_m, double damping_Ns_per_m) noexcept
{
  return coupleAlong(stretch_m, velocity, stiffness_N_per_m, damping_Ns_per_m);
}

} // namespace palpate
