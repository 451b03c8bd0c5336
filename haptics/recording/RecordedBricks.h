// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "haptics/field/Brick.h"
#include "haptics/field/FieldProxy.h"
#include "haptics/recording/ByteStream.h"

namespace palpate
{

/// The payload of a brick's chunk.
void putBrick(ByteWriter& payload, const Brick& brick);
/// Null, with in.ok() false, where the bytes are no brick.
[[nodiscard]] std::shared_ptr<const Brick> readBrick(ByteReader& in);

/// The cells of a field's state are indices, and those of a file are not trusted: they are kept where the brick that
/// they are of is among these and has them. Else the state is forgotten, and the hand meets the field anew.
void keepCellsWithin(const std::vector<std::shared_ptr<const Brick>>& bricks, FieldState& state);

} // namespace palpate
