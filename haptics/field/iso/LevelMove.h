// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/iso/IsoSpace.h"

namespace palpate
{

/// Moves the felt level towards the plan's by what one tick allows, and a proxy that the surface meets with it. False
/// where the pocket that the proxy was in has vanished: it could not follow for a tenth of a second.
[[nodiscard]] bool moveLevel(const IsoSpace& space, const IsoPlan& plan, IsoState& state, FieldPathSink* sink) noexcept;

} // namespace palpate
