// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tool/servo/ToolForce.h"

namespace palpate
{

/// New contacts may step the pull at once: a snap over an edge, or an update that was late. The part above
/// the largest step is spread over the time after it.
struct ToolBlend
{
  static constexpr double largestStep_N = 0.2; ///< felt at once
  static constexpr double fade_s = 0.03;       ///< time constant of the rest

  Vec3 way_u = Vec3::Zero();  ///< part of earlier steps that is left in the pull
  Vec3 turn_u = Vec3::Zero(); ///< likewise, rotation times the lever arm

  /// The pull of a tick. `step_u`: its change by other contacts at the same pose of the hand.
  [[nodiscard]] Vec6 blended(const Vec6& pull_u, const Vec6& step_u, double stiffness_N_per_u, double dt_s) noexcept;
};

} // namespace palpate
