// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/core/Types.h"

namespace palpate
{

/// How much of a whole a scene has, where the whole is too large to be here: all that is within a ball, exactly. A hand
/// feels there the same as in the whole as long as hand and proxy, with the ball that touches, are
/// within.
struct LoadedRegion
{
  std::uint64_t geometry = 0;   ///< Scene::geometryHash() of the scene that this is said of; 0: of none, all are whole
  std::uint64_t continues = 0;  ///< likewise of the part of the same whole that was felt before; 0: there was none
  Vec3 centre_W = Vec3::Zero(); ///< [u]
  double reach_u = 0.0;
  std::uint64_t asked = 0; ///< number of the request for another part that is under way; 0: none is

  /// Whether all of a ball is known; false where its numbers are none.
  [[nodiscard]] bool has(const Vec3& p_W, double radius_u) const noexcept
  {
    return (p_W - this->centre_W).norm() + radius_u <= this->reach_u;
  }
};

} // namespace palpate
