// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace palpate
{

/// Use of one chance to send a report.
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

/// How a force along an axis of HID is asked for: where it comes from, clockwise from -y, and the sign of its
/// magnitude. Along x as Windows does with a wheel, so that a device of one motor may ignore the angle.
struct PidAxis
{
  double comesFrom_deg;
  double sign;
};
inline constexpr std::array<PidAxis, 2> pidAxes{ { { 90.0, -1.0 }, { 0.0, 1.0 } } };

} // namespace palpate
