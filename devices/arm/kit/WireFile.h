// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "devices/arm/kit/WiredArm.h"

namespace palpate
{

/// The arm of an arm file with its object "wire": docs/arms.md has the keys. The text is not trusted: one phrase with
/// the place and the reason where something is missing, unknown or impossible. The devices that the wire names are told
/// also where the rest is refused, as far as they can be read.
[[nodiscard]] Outcome<WiredArm> parseWiredArm(const std::string& text);

/// The same for an arm that is built in, or for a file, with whose name the phrase begins.
[[nodiscard]] Outcome<WiredArm> wiredArmNamed(const std::string& nameOrFile);

} // namespace palpate
