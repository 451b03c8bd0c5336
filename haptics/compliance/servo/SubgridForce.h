// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "haptics/compliance/snapshot/ComplianceSnapshot.h"

namespace palpate
{

/// Cube root of x >= 0, to rounding and the same everywhere: a third of the exponent, then Newton's steps.
[[nodiscard]] inline double cubeRoot(double x) noexcept
{
  if (!(x > 1e-300))
  {
    return 0.0;
  }
  constexpr std::uint64_t twoThirdsOfBias =
    0x2A9F7893782DA1CEu; // 2/3 of 1023 << 52, less the offset of that line (fdlibm)
  double t = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + twoThirdsOfBias);
  for (int i = 0; i < 5; ++i)
  {
    t -= (t - x / (t * t)) / 3.0;
  }
  return t;
}

/// Further depth of a ball under a normal force beyond that of its patch [u], and the slope of that [u/N].
struct SubgridDepth
{
  double depth_u = 0.0;
  double slope = 0.0;
};

/// One piece of a spring with knots: s(t) for t0 <= t <= t0 + step.
struct SubgridPiece
{
  double t0 = 0.0;
  std::array<double, 4> c{}; ///< of 1, (t - t0), (t - t0)^2, (t - t0)^3

  [[nodiscard]] double depthAt(double t) const noexcept
  {
    const double u = t - this->t0;
    return this->c[0] + u * (this->c[1] + u * (this->c[2] + u * this->c[3]));
  }
};

[[nodiscard]] inline SubgridPiece pieceOf(const SubgridSpring& spring, std::size_t piece) noexcept
{
  const double h = spring.step;
  const double rises_u = spring.depth_u[piece + 1] - spring.depth_u[piece];
  const double begins = spring.rise[piece];
  const double ends = spring.rise[piece + 1];
  return { h * static_cast<double>(piece),
    { spring.depth_u[piece], begins, (3.0 * rises_u / h - 2.0 * begins - ends) / h,
      (begins + ends - 2.0 * rises_u / h) / (h * h) } };
}

/// Depth of a spring with knots.
[[nodiscard]] inline SubgridDepth depthByKnots(const SubgridSpring& spring, double force_N) noexcept
{
  constexpr std::size_t last = SubgridSpring::knots - 1;
  const double end = spring.step * static_cast<double>(last);
  const double t = cubeRoot(std::max(force_N, 0.0));
  if (t >= end)
  {
    const double slope = spring.rise[last] / (3.0 * end * end);
    return { spring.depth_u[last] + slope * (force_N - end * end * end), slope };
  }
  const auto piece = std::min(static_cast<std::size_t>(t / spring.step), last - 1);
  const SubgridPiece at = pieceOf(spring, piece);
  if (piece == 0) // s = c2 t^2 + c3 t^3, as of Hertz: its slope by the force is unbounded at 0
  {
    return { t * t * (at.c[2] + t * at.c[3]), 2.0 * at.c[2] / (3.0 * std::max(t, 1e-9 * end)) + at.c[3] };
  }
  const double u = t - at.t0;
  return { at.depthAt(t), (at.c[1] + u * (2.0 * at.c[2] + 3.0 * u * at.c[3])) / (3.0 * t * t) };
}

/// Without knots the patch has all of the compliance once the contact is .76 times as wide: the depth stays.
[[nodiscard]] inline SubgridDepth subgridDepth(const SubgridSpring& spring, double force_N) noexcept
{
  if (spring.hertz <= 0.0)
  {
    return {};
  }
  if (spring.step > 0.0)
  {
    return depthByKnots(spring, force_N);
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

/// Integral of the depth of a spring with knots from 0 to a force [N u]: 3 t^2 s(t), whose pieces Gauss's rule with
/// three points integrates exactly.
[[nodiscard]] inline double energyByKnots(const SubgridSpring& spring, double force_N) noexcept
{
  constexpr std::size_t last = SubgridSpring::knots - 1;
  constexpr std::array<double, 3> points{ 0.1127016653792583, 0.5, 0.8872983346207417 };
  constexpr std::array<double, 3> weights{ 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
  const double end = spring.step * static_cast<double>(last);
  const double t = std::min(cubeRoot(force_N), end);
  double sum = 0.0;
  for (std::size_t piece = 0; piece < last && spring.step * static_cast<double>(piece) < t; ++piece)
  {
    const SubgridPiece at = pieceOf(spring, piece);
    const double width = std::min(t - at.t0, spring.step);
    for (std::size_t g = 0; g < points.size(); ++g)
    {
      const double x = at.t0 + points[g] * width;
      sum += weights[g] * width * 3.0 * x * x * at.depthAt(x);
    }
  }
  const double beyond_N = std::max(force_N - end * end * end, 0.0);
  return sum + beyond_N * (spring.depth_u[last] + 0.5 * beyond_N * spring.rise[last] / (3.0 * end * end));
}

/// Integral of the spring's depth from 0 to a force [N u].
[[nodiscard]] inline double subgridEnergy(const SubgridSpring& spring, double force_N) noexcept
{
  if (spring.hertz <= 0.0 || force_N <= 0.0)
  {
    return 0.0;
  }
  if (spring.step > 0.0)
  {
    return energyByKnots(spring, force_N);
  }
  const double last = 2.0 * spring.hertz / (3.0 * spring.patch);
  const double t = std::min(cubeRoot(force_N), last);
  const double rising = t * t * t * t * t * (0.6 * spring.hertz - 0.5 * spring.patch * t);
  // dE = s dF = (h t^2 - p t^3) 3 t^2 dt
  return rising + std::max(force_N - t * t * t, 0.0) * t * t * (spring.hertz - spring.patch * t);
}

} // namespace palpate
