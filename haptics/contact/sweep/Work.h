// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/// Work of the steps of a tick, in units of about one visited node of a tree.
/// Measured on fans and noise, not proven: a tick near the budget of 60,000 takes 1.2 to 1.3 ms, 20 ns a unit.
namespace palpate::work
{

/// A face that may be near, with the borders that it answers for.
inline constexpr std::uint32_t faceTest = 3;
/// A point against a face whose plane it comes to: five orientations.
inline constexpr std::uint32_t pointTest = 16;
/// The same where one of them is 0: then several were not told by doubles and took expansions.
inline constexpr std::uint32_t exactTest = 400;
/// So many triangles round a vertex are looked at in a unit.
inline constexpr std::uint32_t fanSteps = 2;
/// Two or three planes at a time that are tried to hold the ball.
inline constexpr std::uint32_t planeSet = 6;

} // namespace palpate::work
