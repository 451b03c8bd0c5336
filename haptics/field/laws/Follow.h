// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/field/FieldBlock.h"

namespace palpate
{

/// The place of a streamline that is abreast of the hand.
struct Followed
{
  Vec3 y_W = Vec3::Zero();
  Vec3 along_W = Vec3::UnitX(); ///< unit, of the vectors there
  double speed = 0.0;           ///< their length
};

/// Goes along the streamline through x_W until the hand at p_W is neither before nor behind, at most `mostSteps` steps
/// of a cell. By the implicit midpoint rule, which keeps circles of linear fields and comes back on the curve it went:
/// the tangent line at x, taken instead, gives the hand energy wherever it is outside the curve. A vector and its
/// opposite are the same direction, as for eigenvectors. None where there are no vectors, or no length.
[[nodiscard]] std::optional<Followed> followStreamline(
  const FieldBlock& brick, const Vec3& x_W, const Vec3& p_W, int mostSteps = 8) noexcept;

} // namespace palpate
