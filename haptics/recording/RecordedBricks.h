// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/field/Brick.h"
#include "haptics/recording/ByteStream.h"

namespace palpate
{

/// The payload of a brick's chunk.
void putBrick(ByteWriter& payload, const Brick& brick);
/// Null, with in.ok() false, where the bytes are no brick.
[[nodiscard]] std::shared_ptr<const Brick> readBrick(ByteReader& in);

} // namespace palpate
