// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace palpate
{

/// What one chance to send a report was used for.
enum class PidStep : std::uint8_t
{
  Idle, ///< the device has all it needs
  Sent,
  Failed,
};

[[nodiscard]] constexpr PidStep sentOrFailed(bool taken) noexcept
{
  return taken ? PidStep::Sent : PidStep::Failed;
}

/// The directions of an effect along +x and +y of HID, clockwise from -y.
inline constexpr double alongX_deg = 90.0, alongY_deg = 180.0;

} // namespace palpate
