// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// Sign of the determinant |b-a, c-a, d-a|: +1 when d lies on the side of triangle (a, b, c) that its
/// right-hand normal (b-a) x (c-a) points to, -1 on the other side, 0 exactly in the plane.
///
/// Exact for all finite doubles whose products neither overflow nor underflow (Shewchuk 1997, expansion
/// arithmetic behind a forward error filter). Allocation-free and bounded, so that the tick may call it;
/// needs IEEE doubles in round-to-nearest and no contraction of a*b+c.
[[nodiscard]] int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept;

/// The same for three points of a plane given by two coordinates each: sign of |b-a, c-a|.
[[nodiscard]] int orientation2(double ax, double ay, double bx, double by, double cx, double cy) noexcept;

/// True if the three points lie exactly on one line (or coincide).
[[nodiscard]] bool exactlyCollinear(const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

/// (b-a) x (c-a) with each coordinate rounded once only, however thin the triangle; zero if it has no area. The same
/// conditions as above, for products of two coordinates.
[[nodiscard]] Vec3 exactCross(const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

} // namespace palpate
