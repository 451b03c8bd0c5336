// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "haptics/core/Types.h"

namespace palpate
{

/// A force that rises, stays for a moment and goes, half a second in all: harmless, and slow enough for a hand to yield
/// like a spring.
namespace push
{
constexpr double rise_s = 0.40;
constexpr double stay_s = 0.05;
constexpr double fall_s = 0.05;
constexpr double all_s = rise_s + stay_s + fall_s;
constexpr double rest_s = 0.25; ///< without force afterwards, still watched

/// Share of the largest force at a time since it began, 0 .. 1. Real-time safe.
[[nodiscard]] double share(double time_s) noexcept;

/// As long, but soon strong: then nobody renews it.
constexpr double lapse_s = 0.15;
[[nodiscard]] double lapsingShare(double time_s) noexcept;
} // namespace push

/// The effect of a push along one axis of measurement.
struct PushAnswer
{
  double moved_m = 0.0;          ///< at the end, with sign
  double early_m = 0.0;          ///< while there was hardly any force yet
  double response_m_per_N = 0.0; ///< slope of the motion over the force, once it moved; < 0: against it
  double mean_m = 0.0;           ///< of the displacement while the force rose, with sign: braking reduces it
  double most_m = 0.0;           ///< the largest way, with sign, even after the force
  double reached_s = 0.0;        ///< when it was nearly that far
  double last_m = 0.0;           ///< just before the force ends
  double rested_m = 0.0;         ///< at the end of the rest
};

/// Watches a push and the rest after it: where the hand was at which force. Friction shifts the force at which motion
/// begins, not the slope afterwards. Real-time safe.
class PushRecord
{
public:
  void begin(const Vec3& p_D) noexcept;
  void add(double time_s, const Vec3& p_D) noexcept;
  /// `force_N`: the largest, with sign.
  [[nodiscard]] PushAnswer answer(int axis, double force_N) const noexcept;

private:
  static constexpr std::size_t risingBins = 64;
  static constexpr double bin_s = push::rise_s / risingBins;
  static constexpr std::size_t bins = 120; ///< the push and the rest after it

  /// Mean way in one of the bins; 0 in one that nothing fell into.
  [[nodiscard]] double way(std::size_t bin, int axis) const noexcept;
  /// The same over the bins between two times.
  [[nodiscard]] double meanWay(double from_s, double to_s, int axis) const noexcept;
  [[nodiscard]] double slope(int axis, double force_N, double least_m) const noexcept;
  void findMost(int axis, PushAnswer& answer) const noexcept;

  Vec3 from_D_ = Vec3::Zero();
  std::array<Vec3, bins> sums_{};
  std::array<int, bins> counts_{};
};

} // namespace palpate
