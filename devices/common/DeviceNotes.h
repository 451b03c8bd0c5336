// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/core/DeviceInfo.h"

namespace palpate
{

/// Functions that a device of that kind lacks, for its user: sentences, or empty. Pure.
[[nodiscard]] std::string shortcomings(const DeviceInfo& device);

/// Why walls are not left to a device that offers to hold them, as part of a sentence; empty: they are. Pure.
[[nodiscard]] const char* whyNotHeld(HeldProof proof) noexcept;

/// The kind of a device, in a few words: "2 axes of force". Pure.
[[nodiscard]] std::string kindOf(const DeviceInfo& device);

} // namespace palpate
