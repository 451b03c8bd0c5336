// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/constraints/ConstraintRows.h"

namespace palpate
{

/// Where a tip that goes from one place to another comes into a soft body from outside, into the constraint's state.
/// The body's vertices are taken where they are without forces. Real-time safe.
[[nodiscard]] bool meetSurface(
  const PressedBody& body, const Vec3& from_W, const Vec3& to_W, ConstraintState& state) noexcept;

/// A tip that is pressed on and has gone along the surface by `aside_W` from its place there. False, and nothing
/// changes, where no surface is under it any more: beyond an edge. Real-time safe.
[[nodiscard]] bool slideOnSurface(const PressedBody& body, const Vec3& aside_W, ConstraintState& state) noexcept;

} // namespace palpate
