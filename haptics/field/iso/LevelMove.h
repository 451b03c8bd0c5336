// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/iso/IsoSpace.h"

namespace palpate
{

/// Moves the felt level towards the plan's by the largest change of one tick, and a proxy that the surface meets with
/// the surface. False where the pocket of the proxy has vanished: the proxy could not follow for a tenth of a second.
[[nodiscard]] bool moveLevel(const IsoSpace& space, const IsoPlan& plan, IsoState& state, FieldPathSink* sink) noexcept;

} // namespace palpate
