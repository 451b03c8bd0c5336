// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "haptics/recording/Recording.h"
#include "haptics/recording/bytes/ByteStream.h"
#include "haptics/recording/bytes/RecordingLayout.h"

namespace palpate
{

/// A chunk as it is read back.
struct RecordedChunk
{
  std::string name;
  std::uint32_t version = 0;
  std::uint64_t number = 0; ///< from 1 on
  ByteReader payload{ nullptr, 0 };
  bool headDamaged = false; ///< it is not what was written: neither is where its payload ends
  bool payloadDamaged = false;
};

/// The next chunk of bytes that are not trusted; what it says is true while in.ok() and nothing is damaged.
[[nodiscard]] RecordedChunk nextChunk(ByteReader& in);

/// Enters what a chunk of one kind holds into a recording; the payload is ok() and at its end if it is what it should
/// be.
struct ChunkReader
{
  ChunkKind kind;
  std::function<void(RecordedChunk&, Recording&)> read;
};

/// Nothing for a kind that this program does not know.
[[nodiscard]] std::optional<ChunkReader> readerOf(const std::string& name);

} // namespace palpate
