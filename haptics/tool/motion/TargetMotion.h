// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

using Vec6 = Eigen::Matrix<double, 6, 1>;

/// The whitened motion: displacement, and turn times lever, both in scene units, so that the metric is the identity.
[[nodiscard]] inline Vec6 whitened(const Vec3& v, const Vec3& w, double characteristic_u) noexcept
{
  Vec6 y;
  y << v, characteristic_u * w;
  return y;
}

/// The whitened motion that would bring the tool from one pose to another. The turn is cut to a lead beyond which its
/// direction means little; `cut` says whether it was. Real-time safe.
[[nodiscard]] Vec6 wishedMotion(const Pose& from_W, const Pose& to_W, double characteristic_u, bool& cut) noexcept;

/// The function of `from_W` that falls fastest along the wished motion, by twice its length: its square, and where the
/// turn is cut, one that grows evenly with the angle (Huber's function). Real-time safe.
[[nodiscard]] double wishedDistance2(const Pose& from_W, const Pose& to_W, double characteristic_u) noexcept;

} // namespace palpate
