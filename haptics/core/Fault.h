// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace palpate
{

/// Why a session gives no force. A fault is a value: nothing in the tick throws.
enum class Fault : std::uint8_t
{
  None,
  NonFiniteSample, ///< three non-finite device samples within one second: latched
  LateServo,       ///< a tick gap above 20 ms, or p99 lateness above 5 ms over 5 s
  DeviceLost,      ///< the device stopped answering: latched until the person engages again
  EnergyLatch,     ///< the passivity observer saw more energy delivered than allowed
  VelocityCut,     ///< the handle moved faster than a hand can
  SceneRefused,    ///< the scene is empty or was refused
  PlacementFailed, ///< the ball overlaps a surface and no free place lies within its radius
  NoHand,          ///< the hand's place has not been given yet
  ToolWaits,       ///< the tool meets the scene wherever the hand has been
  BodyLate,        ///< a soft body that is pressed is not computed any more: latched
};

/// One sentence for the panel: the event and the remedy.
[[nodiscard]] const char* describe(Fault fault) noexcept;

} // namespace palpate
