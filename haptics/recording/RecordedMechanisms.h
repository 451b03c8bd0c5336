// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/ByteStream.h"
#include "haptics/recording/Recording.h"

namespace palpate
{

/// The payload of the chunk of a mechanism: its plan and the packets of its soft bodies, whose scenes are chunks of
/// their own.
void putMechanism(ByteWriter& payload, const FeltMechanism& mechanism);
/// Of no use, with in.ok() false, where the bytes are none.
[[nodiscard]] RecordedMechanism readMechanism(ByteReader& in);

/// Numbers that a tick computes with.
[[nodiscard]] bool isUsable(const MechanismState& state);
/// Whether a tick may go on from this state: of another plan, or at vertices that the bodies have.
[[nodiscard]] bool fits(const MechanismState& state, const RecordedMechanism& mechanism);

} // namespace palpate
