// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "devices/arm/kit/WiredArm.h"

namespace palpate
{

/// How WoodenHaptics and Polhem arms are plugged in.
[[nodiscard]] ArmWire woodenHapticsWire();

/// The arm that an owner's ~/woodenhaptics.json describes, flat JSON with numbers in m, N m/A, counts and kg. The
/// problem is a phrase without the file's name.
[[nodiscard]] Outcome<WiredArm> readWoodenHapticsFile(const std::string& text);

} // namespace palpate
