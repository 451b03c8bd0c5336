// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/recording/inputs/InputList.h"
#include "haptics/tool/worker/ToolFollower.h"

namespace palpate
{

/// The payload of the chunk of a tool's contacts.
void putTool(ByteWriter& payload, const ToolContacts& contacts);
/// Of no use, with in.ok() false, where the bytes are none.
[[nodiscard]] ToolContacts readTool(ByteReader& in);

namespace input
{

/// The contacts of the tool in the hand.
struct Tools
{
  using Value = ToolContacts;
  [[nodiscard]] static const ToolContacts*& of(TickInput& tick) noexcept { return tick.tool; }
  static constexpr EventKind event = EventKind::Tool;
  [[nodiscard]] static std::uint64_t idOf(const ToolContacts& contacts) noexcept { return contacts.revision; }

  struct Links
  {
    ToolLinks tool; ///< servo <-> the thread that moves a tool
  };
  [[nodiscard]] static auto& buffer(Links& links) noexcept { return links.tool.contacts; }
  template<class Arrivals>
  static void put(Arrivals& arrivals, TickInput& tick) noexcept
  {
    const ToolContacts* const set = std::get<Arrival<Tools>>(arrivals).value;
    tick.tool = set->held && tick.mechanism == nullptr ? set : nullptr;
  }
  /// Beyond the known part of a scene a tool waits where all was known.
  static void tellWorker(const TickDone& done, Links& links) noexcept
  {
    const HapticState& state = done.output.state;
    const bool leads = state.tool.held && !state.held && !state.known.beyond;
    links.tool.hand.write(
      { state.tool.hand_W, leads, done.parameters.contact.friction.kinetic, done.time_s, done.maps });
  }

  static constexpr ChunkKind chunk{ "tool", 3 };
  static void write(ByteWriter& payload, const ToolContacts& contacts) { putTool(payload, contacts); }

  struct Recorded
  {
    std::vector<ToolContacts> tools; ///< in the order in which they were taken
  };
  static void read(ByteReader& payload, Recorded& recorded) { recorded.tools.push_back(readTool(payload)); }
  [[nodiscard]] static const auto& recorded(const Recorded& all) noexcept { return all.tools; }
  static constexpr const char* missing =
    "the surroundings of a tool are missing in the recording, so that the recording cannot be recomputed";
};

} // namespace input
} // namespace palpate
