// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

struct FaceRecord;

/// Exact under the conditions of ExactPredicates; allocation-free, so that the tick may call them.

/// True if the closed segment p q meets the closed triangle; both ends lie exactly in the triangle's plane.
[[nodiscard]] bool meetsInPlane(const Vec3& p, const Vec3& q, const FaceRecord& face) noexcept;

/// True if the line through p and q, which are not both in its plane, meets the closed triangle.
[[nodiscard]] bool linePassesThrough(const Vec3& p, const Vec3& q, const FaceRecord& face) noexcept;

} // namespace palpate
