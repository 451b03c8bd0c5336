// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/DeviceSample.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// Pure functions between the rendered force and the hand. Real-time safe.

/// Shortens a force to maxForce_N and keeps its direction.
[[nodiscard]] Vec3 clampMagnitude(const Vec3& force, double maxForce_N) noexcept;

/// Lets the magnitude grow by at most maxRise * dt over that of the previous force. A change of direction at the
/// same or a smaller magnitude is not limited: release is always free.
[[nodiscard]] Vec3 limitRise(const Vec3& force, const Vec3& previous, double maxRise_N_per_s, double dt_s) noexcept;

/// 3 s^2 - 2 s^3 on [0, 1], clamped outside: no jump in force or in its rate at either end.
[[nodiscard]] double smoothstep(double s) noexcept;

/// True if every number of the sample that forces are computed from is finite, and the hand no further than 1e9 m.
[[nodiscard]] bool isFinite(const DeviceSample& sample) noexcept;

} // namespace palpate
