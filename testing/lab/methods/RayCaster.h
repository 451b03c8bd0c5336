// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "haptics/core/Types.h"

namespace palpate::lab
{

/// A face as a textbook method sees it.
struct Face
{
  std::size_t index = 0;
  Vec3 point_W = Vec3::Zero();   ///< the point of it that was asked for: nearest, or hit
  Vec3 normal_W = Vec3::UnitZ(); ///< unit, right-handed for the stored corners
};

/// A mesh that answers with the first face on a segment.
class RayCaster
{
public:
  virtual ~RayCaster() = default;
  /// The first face that the segment crosses from its front or its back.
  [[nodiscard]] virtual std::optional<Face> firstHit(const Vec3& from_W, const Vec3& to_W) const = 0;
};

} // namespace palpate::lab
