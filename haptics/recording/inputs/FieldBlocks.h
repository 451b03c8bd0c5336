// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "haptics/field/FieldBlock.h"
#include "haptics/field/proxy/FieldProxy.h"
#include "haptics/recording/inputs/InputList.h"

namespace palpate
{

/// The payload of a block's chunk.
void putFieldBlock(ByteWriter& payload, const FieldBlock& brick);
/// Null, with in.ok() false, where the bytes are no block.
[[nodiscard]] std::shared_ptr<const FieldBlock> readFieldBlock(ByteReader& in);

/// The cells of a field's state are indices, and those of a file are not trusted: they are kept where the block that
/// they are of is among these and has them. Else the state is forgotten, and the hand meets the field anew.
void keepCellsWithin(const std::vector<std::shared_ptr<const FieldBlock>>& bricks, FieldState& state);

namespace input
{

/// The field around the hand.
struct FieldBlocks
{
  using Value = FieldBlock;
  [[nodiscard]] static const FieldBlock*& of(TickInput& tick) noexcept { return tick.brick; }
  static constexpr EventKind event = EventKind::FieldBlock;
  [[nodiscard]] static std::uint64_t idOf(const FieldBlock& brick) noexcept { return brick.contentHash(); }
  [[nodiscard]] static bool replaces(const TickInput& tick, const RendererState& state) noexcept
  {
    const std::uint64_t before = state.field.brick;
    return before != 0 && (tick.brick == nullptr || tick.brick->called(before) == nullptr);
  }

  struct Links
  {
    SnapshotMailbox<FieldBlock> bricks; ///< owner -> servo
  };
  [[nodiscard]] static auto& buffer(Links& links) noexcept { return links.bricks; }

  static constexpr ChunkKind chunk{ "brick", 4 };
  static void write(ByteWriter& payload, const FieldBlock& brick) { putFieldBlock(payload, brick); }

  struct Recorded
  {
    std::vector<std::shared_ptr<const FieldBlock>> bricks; ///< each once
  };
  static void read(ByteReader& payload, Recorded& recorded) { recorded.bricks.push_back(readFieldBlock(payload)); }
  [[nodiscard]] static const auto& recorded(const Recorded& all) noexcept { return all.bricks; }
  static constexpr const char* missing =
    "a rendered field is missing in the recording, so that the recording cannot be recomputed";
};

} // namespace input
} // namespace palpate
