// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

using Vec6 = Eigen::Matrix<double, 6, 1>;

/// The whitened motion: displacement, and rotation times lever arm, both in scene units: the metric is the identity.
[[nodiscard]] inline Vec6 whitened(const Vec3& v, const Vec3& w, double characteristic_u) noexcept
{
  Vec6 y;
  y << v, characteristic_u * w;
  return y;
}

/// The whitened motion that would bring the tool from one pose to another. The rotation is limited to a lead beyond
/// which its direction means little; `cut` says whether it was. Real-time safe.
[[nodiscard]] Vec6 wishedMotion(const Pose& from_W, const Pose& to_W, double characteristic_u, bool& cut) noexcept;

/// The function of `from_W` that falls fastest along the wished motion, with twice its length as slope: its square, and
/// where the rotation is limited, one that grows linearly with the angle (Huber's function). Real-time safe.
[[nodiscard]] double wishedDistance2(const Pose& from_W, const Pose& to_W, double characteristic_u) noexcept;

} // namespace palpate
