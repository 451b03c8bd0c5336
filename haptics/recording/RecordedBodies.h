// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/compliance/servo/PressedBody.h"
#include "haptics/recording/ByteStream.h"

namespace palpate
{

/// The payload of the chunk of a soft body's packet. Its scene and the places of its vertices are those of the scene.
void putBody(ByteWriter& payload, const PressedBody& body);
/// Null, with in.ok() false, where the bytes are none.
[[nodiscard]] std::shared_ptr<const PressedBody> readBody(ByteReader& in);

/// How its springs go on between their knots.
void putKnots(ByteWriter& payload, const PressedBody& body);
void readKnots(ByteReader& in, PressedBody& body);

/// The faces of it that nothing moves.
void putHeld(ByteWriter& payload, const PressedBody& body);
void readHeld(ByteReader& in, PressedBody& body);

} // namespace palpate
