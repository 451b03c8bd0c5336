// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by tests of bending surfaces, whether their frame stands or moves.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "testing/support/AllocationGuard.h"
#include "testing/support/Bender.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{

inline constexpr double twoPi = 2 * std::numbers::pi;
inline constexpr double K = 1000.0;
inline constexpr int at20Hz = 50; // ticks a snapshot

[[nodiscard]] inline TriangleMesh sheetOf(int cells, std::uint64_t seed)
{
  Random random(testSeed(seed));
  return makeSheet({ 0.2, 0.2, cells, cells, 0.2 }, random);
}

/// A sheet that rises by `speed` [u/s] in paths of 20 ticks, some of them cut short, pushes a hand that rests ever
/// harder.
inline void expectNoStepWhereWaysAreCutShort(Bender& sheet, const Vec3& hand, double speed)
{
  static_cast<void>(sheet.tick(hand + Vec3(0, 0, 0.01)));
  double before = sheet.tick(hand).state.force_D.z();
  for (int i = 3; i <= 400; ++i)
  {
    if (i % 33 == 0)
    {
      sheet.cutShort();
    }
    const double force = sheet.tick(hand).state.force_D.z();
    // A path cut short leaves up to 20 ticks' rise for the next one: at most twice as fast, never a step.
    ASSERT_GE(force, before - 1e-9) << "tick " << i;
    ASSERT_LE(force, before + 2 * K * speed * 1e-3 + 1e-9) << "tick " << i;
    before = force;
  }
}

/// Allocations, frees and locks of 200 ticks in which a hand comes down and strokes.
[[nodiscard]] inline std::uint64_t disturbancesUnderAStroke(Bender& sheet)
{
  std::uint64_t disturbed = 0;
  sheet.compute = [&](const TickInput& input)
  {
    const AllocationGuard guard;
    const TickOutput output = renderTick(input, sheet.parameters, sheet.state);
    disturbed += guard.allocations() + guard.frees() + guard.locks();
    return output;
  };
  for (int i = 1; i <= 200; ++i)
  {
    static_cast<void>(sheet.tick({ 0.02 * std::sin(0.01 * i), 0.0023, i < 3 ? 0.05 : -8e-3 }));
  }
  return disturbed;
}

} // namespace palpate::test
