// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/contact/view/GodObjectState.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// The feature of another scene whose corners have the same coordinates, to the bit: of a surface of which another part
/// is there now, the touched feature is often in both parts. Nothing where there is none, or where a surface is posed
/// or moves. Bounded and allocation-free.
[[nodiscard]] std::optional<ActiveFeature> sameFeature(
  const Scene& from, const ActiveFeature& feature, const Scene& to) noexcept;

} // namespace palpate
