// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "haptics/core/Types.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// The same force wherever the hand is: it carries the weight of a handle, or adds one. A force that never changes has
/// a potential, so a closed path takes no work.
struct ConstantForce
{
  static constexpr std::string_view name = "constant force";

  struct Plan
  {
    Vec3 constantForce_W = Vec3::Zero(); ///< on the hand [N], no larger than the largest force of the limits is used
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("force_W", p.constantForce_W...);
  }
  [[nodiscard]] static std::string refuse(const Plan& p)
  {
    return p.constantForce_W.allFinite() ? "" : "constant force [N] must be finite";
  }

  static void step(TickContext& tick) noexcept;
};

} // namespace palpate::stage
