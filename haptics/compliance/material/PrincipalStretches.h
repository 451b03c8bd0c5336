// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// F = U diag(s) V^T with U and V turns: where F mirrors, the last stretch is below 0.
struct PrincipalStretches
{
  Mat3 u = Mat3::Identity();
  Vec3 s = Vec3::Ones();
  Mat3 v = Mat3::Identity();
};

/// By turning columns to right angles in pairs (Hestenes 1958): in a third of the time of a general decomposition, and
/// a stiffness asks for one an element.
[[nodiscard]] PrincipalStretches principalStretches(const Mat3& f);

} // namespace palpate
