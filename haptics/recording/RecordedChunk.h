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
  bool headDamaged = false; ///< the head's checksum is wrong, so the end of the payload is unknown
  bool payloadDamaged = false;
};

/// The next chunk of bytes that are not trusted; valid while in.ok() and nothing is damaged.
[[nodiscard]] RecordedChunk nextChunk(ByteReader& in);

/// Enters the payload of a chunk of one kind into a recording; a payload in order is ok() and at its end afterwards.
struct ChunkReader
{
  ChunkKind kind;
  std::function<void(RecordedChunk&, Recording&)> read;
};

/// Nothing for a kind that this program does not know.
[[nodiscard]] std::optional<ChunkReader> readerOf(const std::string& name);

} // namespace palpate
