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
  static constexpr int most = 6; ///< at a time: as many as there are degrees of freedom

  Vec3 p_W = Vec3::Zero();  ///< point of contact [u]
  Vec3 n_W = Vec3::UnitZ(); ///< unit, from the scene to the tool
  double push_u = 0.0;      ///< its normal force over the stiffness
  int contact = 0;          ///< index in the set
};

/// The motion nearest to a wished one that the contacts allow, whitened, and the contacts that push.
struct AllowedMotion
{
  Vec6 y = Vec6::Zero();
  int active = 0;                                   ///< contacts that push
  std::array<ToolPress, ToolPress::most> presses{}; ///< the pushing ones; where they are not unique their sum is
};

/// To stay is always allowed, also where rounding leaves the solver without a solution. Real-time
/// safe.
[[nodiscard]] AllowedMotion allowedMotion(const ToolContacts& set, const Vec6& wish) noexcept;

} // namespace palpate
