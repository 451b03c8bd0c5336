// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ContactSet.h"

namespace palpate
{

/// A move of a ball round the edges and vertices that hold it: along the old tangent planes, then along the new.
struct RollPlan
{
  bool worthwhile = false;
  Vec3 first = Vec3::Zero();  ///< displacement from x to the corner of old and new tangent planes
  Vec3 second = Vec3::Zero(); ///< displacement from x to the new place
};

/// Plans a roll towards p (THEORY.md 2.7 ROLL): tangent planes alone converge like depth / r and diverge for
/// depth > r; the pair of tangents converges quadratically and keeps the way outside of the round obstacle.
/// `solution` is the projection of p - x onto the touched planes, with multipliers l.
[[nodiscard]] RollPlan planRoll(const ContactSet& contacts, const Vec3& x_W, const Vec3& p_W, double radius_u,
  const ProjectionResult& solution) noexcept;

} // namespace palpate
