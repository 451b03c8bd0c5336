// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/servo/MechanismTick.h"

namespace palpate
{

/// A tick of a mechanism that is a wire: `ticks` has its contacts. Changes of its force are its own, and are not
/// spread. Real-time safe.
void stepWire(const MechanismInput& input, WireTick& ticks, MechanismState& state, MechanismResult& result) noexcept;

} // namespace palpate
