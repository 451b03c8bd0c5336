// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/ByteStream.h"
#include "haptics/recording/Recording.h"

namespace palpate
{

/// The payloads of a scene's and of a motion's chunk; what they say is true while in.ok().
[[nodiscard]] RecordedScene readScene(ByteReader& in);
[[nodiscard]] RecordedMotion readMotion(ByteReader& in);

} // namespace palpate
