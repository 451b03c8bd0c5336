// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/wire/WireNewton.h"

namespace palpate
{

/// Supports of a wire in its sheath, which runs along x and ends at the origin. Nodes behind the mouth keep the axis
/// and its direction. The node that comes out next is held by springs that fade, so that a beam that grows out of the
/// sheath makes no step in the force. The sheath takes the energy that the springs lose: the wire's own bend at the
/// mouth neither pushes the wire out nor brakes it. Nodes that are behind by a beam's length are brought onto the axis.
/// Real-time safe.
void holdInSheath(const Wire& wire, WirePlaces& places_M, WireLoads& loads) noexcept;

} // namespace palpate
