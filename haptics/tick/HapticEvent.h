// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/tick/HapticParameters.h"

namespace palpate
{

/// Things that must not be lost between threads, nor missing from a recording.
enum class EventKind : std::uint8_t
{
  Engage,          ///< the person asks for force
  Release,         ///< the person lets go
  Mark,            ///< a note in the recording
  Scene,           ///< the tick took another scene (value: content hash)
  Parameters,      ///< the tick took other parameters
  Fault,           ///< a fault was raised in the tick before it (value: Fault)
  Play,            ///< another game in the labyrinth: the hand is brought to the start
  FieldBlock,      ///< the tick took another field (value: content hash)
  Tool,            ///< the tick took other contacts of a tool (value: their revision; 0: no tool)
  Body,            ///< the tick took another snapshot of a soft body (value: its revision; 0: no body)
  Mechanism,       ///< the tick took another mechanism, or snapshots of one (value: its revision; 0: no mechanism)
  BreakConstraint, ///< the person breaks a constraint of the mechanism (value: its place in the plan)
  Constraint,      ///< a constraint changed in the tick before it (value: its place in the plan, plus 2^32 times the
                   ///< ConstraintChange)
};

struct HapticEvent
{
  std::uint64_t tick = 0; ///< the tick that took it
  EventKind kind = EventKind::Mark;
  std::uint64_t value = 0;
};

} // namespace palpate
