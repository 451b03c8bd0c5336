// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/recording/Recording.h"
#include "haptics/recording/bytes/RecordingLayout.h"

namespace palpate
{

/// The bytes of a chunk at its place, the first of a recording being 1: its head, then its payload.
[[nodiscard]] std::vector<char> recordedChunk(const NewChunk& chunk, std::uint64_t number);

/// The header of a recording as bytes, and the chunks that are no input of the tick.
[[nodiscard]] std::string recordingHeader(const std::string& device);
[[nodiscard]] NewChunk startChunk(const HapticParameters& parameters, const RendererState& state);
[[nodiscard]] NewChunk tickChunk(const TickRecord& record);
[[nodiscard]] NewChunk changeChunk(const RecordedChange& change);
[[nodiscard]] NewChunk endChunk(std::uint64_t lost);

} // namespace palpate
