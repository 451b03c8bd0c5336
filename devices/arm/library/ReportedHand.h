// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "devices/arm/ArmLine.h"

namespace palpate
{

/// The reason that is told of an answer that is nonsense, as a phrase.
inline constexpr const char* noHand = "the vendor's library reports a position, a speed or a turn that no hand has";

/// An answer with the hand as a vendor's library reports it in the device frame D: place [m], velocity [m/s], rotation.
/// The answer is nonsense where a number is not finite or beyond every arm, and where the matrix is no rotation.
[[nodiscard]] ArmLine::Answer reportedHand(
  const Vec3& p_D, const Vec3& velocity_D, const Mat3& turn_D, std::uint32_t buttons);

} // namespace palpate
