// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace palpate
{

/// What a push of the self-test is for.
enum class PushKind : std::uint8_t
{
  WarmUp, ///< friction keeps a hand where it last came from: the first pushes only loosen it
  Free,   ///< by a constant force alone
  Wall,   ///< into a wall that the device holds where the hand rests
  Braked, ///< against the viscosity that the device gives
  Lapse,  ///< by a constant force that nobody renews
};

/// One push of one motor. Repetition 0 and 1 are told apart: what differs between them is not the device's.
struct PushRound
{
  PushKind kind = PushKind::WarmUp;
  bool up = true; ///< a positive command
  std::uint8_t repetition = 0;
};

/// All pushes of one motor, each with what it is compared with close by: a hand does not stay the same for long.
inline constexpr std::array<PushRound, 15> pushRounds{ {
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
  { PushKind::Lapse, true, 0 },
} };

} // namespace palpate
