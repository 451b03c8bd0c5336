// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/geometry/scene/Scene.h"
#include "testing/support/CostSample.h"
#include "testing/support/NoisySphere.h"

namespace palpate::test
{

/// How a random hand plays with a ball on a noisy sphere, from one of its sides.
struct SphereGame
{
  ContactPlan plan;    ///< with the ball's radius
  bool inside = false; ///< of the sphere
  std::size_t ticks = 0;
  std::uint64_t seed = 0;
};

/// The outcome.
struct SpherePlay
{
  std::size_t overBudget = 0, touching = 0; ///< ticks
  std::uint32_t mostNodes = 0;              ///< of a tick
  CostSample cost;
};

[[nodiscard]] SpherePlay playOn(const NoisySphere& sphere, const SphereGame& game);

/// A tick of a sixteenth of the passes and of the work, so with the same limit as by default: a sweep may take a
/// sixteenth of all its work, not a 256th.
[[nodiscard]] ContactPlan fewPasses();

/// Above this radius a single sweep of a ball at rest takes more than all the work of a tick, at least where the
/// triangles are smallest: the limit if a tick had as many times its work as it may have sweeps [u].
[[nodiscard]] double radiusOfOneSweep_u(const Scene& scene, ContactPlan plan);

} // namespace palpate::test
