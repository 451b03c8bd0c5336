// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "devices/arm/link/FtdiPort.h"
#include "haptics/core/Clock.h"

namespace palpate
{

/// How a Falcon is brought to answer packets (facts of libnifalcon/libnifalcon). Firmware is a maker's file that a
/// person has: it is neither shipped nor fetched.

/// Sets the chip for packets. False: the device is gone.
[[nodiscard]] bool setForPackets(FtdiPort& port) noexcept;

/// Loads firmware; each piece must be echoed, within a time by that clock. Empty, or one phrase with the reason.
[[nodiscard]] std::string loadFalconFirmware(
  FtdiPort& port, std::span<const std::uint8_t> firmware, const Clock& clock);

} // namespace palpate
