// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace palpate
{

/// Purpose of a push of the self-test.
enum class PushKind : std::uint8_t
{
  WarmUp, ///< friction keeps a hand where it last came from: the first pushes only loosen it
  Free,   ///< by a constant force alone
  Wall,   ///< into a wall that the device holds where the hand rests
  Braked, ///< against the viscosity that the device gives
  /// Up into the upper wall of a corridor, where the hand rests, and down into its room. One wall has its centre where
  /// the hand is, near the middle, and no dead band; a corridor has neither there.
  Corridor,
  Limited, ///< into such a wall that may push with less than the push
  Lapse,   ///< by a constant force that nobody renews
};

/// One push of one motor. Repetitions 0 and 1 are compared: a difference between them does not come from the device.
struct PushRound
{
  PushKind kind = PushKind::WarmUp;
  bool up = true; ///< a positive command
  std::uint8_t repetition = 0;
};

/// All pushes of one motor, each with its reference close by: a hand does not stay the same for long.
inline constexpr std::array<PushRound, 19> pushRounds{ {
  { PushKind::WarmUp, true, 0 },
  { PushKind::WarmUp, false, 0 },
  { PushKind::Free, true, 0 },
  { PushKind::Free, false, 0 },
  { PushKind::Wall, true, 0 },
  { PushKind::Wall, false, 0 },
  { PushKind::Braked, true, 0 },
  { PushKind::Braked, false, 0 },
  { PushKind::Free, true, 1 },
  { PushKind::Free, false, 1 },
  { PushKind::Wall, true, 1 },
  { PushKind::Wall, false, 1 },
  { PushKind::Braked, true, 1 },
  { PushKind::Braked, false, 1 },
  { PushKind::Corridor, true, 0 },
  { PushKind::Corridor, false, 0 },
  { PushKind::Limited, true, 0 },
  { PushKind::Limited, false, 0 },
  { PushKind::Lapse, true, 0 },
} };

} // namespace palpate
