// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "haptics/tool/motion/TargetMotion.h"
#include "haptics/tool/servo/ToolContacts.h"

namespace palpate
{

/// A contact that pushes the tool.
struct ToolPress
{
  static constexpr int most = 6; ///< at a time: as many as there are directions

  Vec3 p_W = Vec3::Zero();  ///< where [u]
  Vec3 n_W = Vec3::UnitZ(); ///< unit, from the scene to the tool
  double push_u = 0.0;      ///< its force over the stiffness
  int contact = 0;          ///< of the set
};

/// The motion nearest to a wished one that the contacts allow, whitened, and what pushes it there.
struct AllowedMotion
{
  Vec6 y = Vec6::Zero();
  int active = 0;                                   ///< contacts that push
  std::array<ToolPress, ToolPress::most> presses{}; ///< those; of more that would do the sum is the same
};

/// To stay where the tool is, is always allowed, also where rounding leaves the solver without an answer. Real-time
/// safe.
[[nodiscard]] AllowedMotion allowedMotion(const ToolContacts& set, const Vec6& wish) noexcept;

} // namespace palpate
