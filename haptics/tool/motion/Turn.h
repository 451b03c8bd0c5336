// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// The rotation vector of a unit quaternion [rad], its length in [0, pi]. Equal for q and -q. Real-time safe: by
/// square roots and a series, so that the bits are the same on every machine.
[[nodiscard]] Vec3 rotationVector(const Quat& q) noexcept;

/// The unit quaternion of a rotation vector [rad] of at most pi. Real-time safe, likewise.
[[nodiscard]] Quat turnBy(const Vec3& turn_rad) noexcept;

/// The rotation vector that leads from one orientation to another, in the frame that both are given in [rad].
[[nodiscard]] inline Vec3 turnFromTo(const Quat& from, const Quat& to) noexcept
{
  return rotationVector(to * from.conjugate());
}

} // namespace palpate
