// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/mechanism/wire/WireTick.h"
#include "haptics/recording/bytes/ByteStream.h"

namespace palpate
{

/// A wire and its vessel, whose triangles keep the order of their tree.
void putWire(ByteWriter& payload, const WirePlan& plan);
/// A wire without its vessel, whose triangles go into `vessel_W`. Null, with in.ok() false, where the bytes are none.
[[nodiscard]] std::shared_ptr<const WirePlan> readWire(ByteReader& in, TriangleMesh& vessel_W);

/// Numbers that a tick computes with.
[[nodiscard]] bool isUsable(const WireState& state);

} // namespace palpate
