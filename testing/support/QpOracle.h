// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "haptics/contact/planes/Projection.h"

namespace palpate::test
{

/// The exact answer to a projection onto planes, rounded once.
struct ExactProjection
{
  bool feasible = false;
  Vec3 y = Vec3::Zero();
};

/// argmin |y - q|^2 subject to n_i . y >= bound_i for exactly the numbers given, in rational arithmetic: every set of
/// at most three independent rows is tried and accepted only if all l >= 0 and every row holds. No tolerance.
[[nodiscard]] ExactProjection projectExactly(std::span<const PlaneRow> rows, const Vec3& q);

} // namespace palpate::test
