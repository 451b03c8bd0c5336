// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/bytes/ByteStream.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate
{

/// Parameters and state as named parts, one a stage of the tick, of named fields. What is read keeps its value where
/// the bytes lack a field. All of `in` is read; damaged bytes and what no stage knows make it fail.
void putParameters(ByteWriter& out, const HapticParameters& parameters);
void putState(ByteWriter& out, const RendererState& state);
/// What a recording that begins with this state knows of it: all but the features that are touched, which are numbers
/// of surfaces and triangles, and the positions of before. Of a field that is felt it knows the cells. Real-time safe.
[[nodiscard]] RendererState recordedPart(const RendererState& state) noexcept;
void getParameters(ByteReader& in, HapticParameters& parameters);
void getState(ByteReader& in, RendererState& state);

} // namespace palpate
