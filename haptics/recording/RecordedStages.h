// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/bytes/ByteStream.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate
{

/// Parameters and state as named parts, one a stage of the tick, of named fields. A field that the bytes lack keeps its
/// value. All of `in` is read; damaged bytes and parts that no stage knows make it fail.
void putParameters(ByteWriter& out, const HapticParameters& parameters);
void putState(ByteWriter& out, const RendererState& state);
/// The part of this state that a recording begins with: all but the features that are touched, which are numbers of
/// surfaces and triangles, and earlier positions. Of a field that is felt the cells are part. Real-time safe.
[[nodiscard]] RendererState recordedPart(const RendererState& state) noexcept;
void getParameters(ByteReader& in, HapticParameters& parameters);
void getState(ByteReader& in, RendererState& state);

} // namespace palpate
