// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "haptics/core/Types.h"

namespace palpate
{

/// Whether a hand can be there: a finite place and a unit quaternion.
[[nodiscard]] inline bool isSound(const Pose& pose) noexcept
{
  return pose.p.allFinite() && std::abs(pose.q.squaredNorm() - 1.0) < 1e-6;
}

} // namespace palpate
