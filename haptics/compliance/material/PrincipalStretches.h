// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// F = U diag(s) V^T with rotations U and V: where F reflects, the last stretch is below 0.
struct PrincipalStretches
{
  Mat3 u = Mat3::Identity();
  Vec3 s = Vec3::Ones();
  Mat3 v = Mat3::Identity();
};

/// By rotations that make pairs of columns orthogonal (Hestenes 1958): in a third of the time of a general
/// decomposition, and a stiffness needs one per element.
[[nodiscard]] PrincipalStretches principalStretches(const Mat3& f);

} // namespace palpate
