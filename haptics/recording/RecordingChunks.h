// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/recording/Recording.h"

namespace palpate
{

/// A chunk of any kind as bytes: its head, then its payload.
[[nodiscard]] std::vector<char> recordedChunk(const ChunkKind& kind, const ByteWriter& payload);

/// The other parts of a recording as bytes: its header, then its chunks.
[[nodiscard]] std::string recordingHeader(const std::string& device);
[[nodiscard]] std::vector<char> startChunk(const HapticParameters& parameters, const RendererState& state);
[[nodiscard]] std::vector<char> tickChunk(const TickRecord& record);
[[nodiscard]] std::vector<char> changeChunk(const RecordedChange& change);
[[nodiscard]] std::vector<char> endChunk(std::uint64_t lost);

} // namespace palpate
