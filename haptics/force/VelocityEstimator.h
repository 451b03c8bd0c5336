// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "haptics/core/Types.h"

namespace palpate
{

/// How a velocity is made from the positions an encoder shows.
enum class VelocityMethod : std::uint8_t
{
  BackwardDifference, ///< no lag beyond half a tick, but steps of resolution / period
  LowPass,            ///< the same through one pole
  AdaptiveWindow,     ///< as long a window as one straight line explains
};

struct VelocityFilter
{
  VelocityMethod method = VelocityMethod::AdaptiveWindow;
  double resolution_m = 0.0; ///< encoder step D: samples within D of a line may lie on it; 0: exact positions
  double lowPass_s = 0.004;  ///< time constant of LowPass
  std::int32_t window = 9;   ///< longest adaptive window [ticks], 1 .. VelocityHistory::capacity - 1
};

/// The last positions, newest first in time. Part of the tick's state.
struct VelocityHistory
{
  static constexpr int capacity = 33;

  std::array<Vec3, capacity> p_D{};
  std::array<double, capacity> dt_s{}; ///< from the position before
  int newest = 0;
  int count = 0;
  Vec3 filtered_D = Vec3::Zero(); ///< state of LowPass [m/s]

  /// Position k ticks ago, k < count.
  [[nodiscard]] int at(int k) const noexcept { return (this->newest - k + capacity) % capacity; }
};

/// Takes the newest position [m], dt after the last one [s], and returns the velocity [m/s]; zero for the first.
///
/// The adaptive window is the "first-order adaptive windowing" of Janabi-Sharifi, Hayward & Chen (2000): the longest
/// window for which the line through its first and last sample passes all samples between within the encoder step.
/// Its error is at most 2 D / (n T) at a constant speed and its lag n T / 2; a fast hand has short windows.
/// Real-time safe, at most window^2 / 2 comparisons.
[[nodiscard]] Vec3 estimateVelocity(
  const VelocityFilter& filter, const Vec3& p_D, double dt_s, VelocityHistory& history) noexcept;

} // namespace palpate
