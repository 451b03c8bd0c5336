// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "haptics/compliance/packet/CompliancePacket.h"

namespace palpate
{

/// Of x >= 0, to rounding and the same everywhere: a third of the exponent, then Newton's steps.
[[nodiscard]] inline double cubeRoot(double x) noexcept
{
  if (!(x > 1e-300))
  {
    return 0.0;
  }
  constexpr std::uint64_t twoThirdsOfBias =
    0x2A9F7893782DA1CEu; // 2/3 of 1023 << 52, less what the line is off (fdlibm)
  double t = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + twoThirdsOfBias);
  for (int i = 0; i < 5; ++i)
  {
    t -= (t - x / (t * t)) / 3.0;
  }
  return t;
}

/// How much deeper a ball is under a normal force than its patch [u], and the slope of that [u/N].
struct SubgridDepth
{
  double depth_u = 0.0;
  double slope = 0.0;
};

/// From where the contact is as wide as .76 of the patch on, the patch is all there is: the depth stays.
[[nodiscard]] inline SubgridDepth subgridDepth(const SubgridSpring& spring, double force_N) noexcept
{
  if (spring.hertz <= 0.0)
  {
    return {};
  }
  const double last = 2.0 * spring.hertz / (3.0 * spring.patch); // cube root of the force there
  const double t = cubeRoot(std::max(force_N, 0.0));
  if (t >= last)
  {
    return { last * last * (spring.hertz - spring.patch * last), 0.0 };
  }
  return { t * t * (spring.hertz - spring.patch * t),
    2.0 * spring.hertz / (3.0 * std::max(t, 1e-9 * last)) - spring.patch };
}

/// Integral of the spring's depth from 0 to a force [N u]; beyond its last depth that depth stays.
[[nodiscard]] inline double subgridEnergy(const SubgridSpring& spring, double force_N) noexcept
{
  if (spring.hertz <= 0.0 || force_N <= 0.0)
  {
    return 0.0;
  }
  const double last = 2.0 * spring.hertz / (3.0 * spring.patch);
  const double t = std::min(cubeRoot(force_N), last);
  const double rising = t * t * t * t * t * (0.6 * spring.hertz - 0.5 * spring.patch * t);
  // dE = s dF = (h t^2 - p t^3) 3 t^2 dt
  return rising + std::max(force_N - t * t * t, 0.0) * t * t * (spring.hertz - spring.patch * t);
}

} // namespace palpate
