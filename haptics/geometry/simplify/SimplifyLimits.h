// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stop_token>

namespace palpate
{

/// Limits of a simplified surface.
struct SimplifyLimits
{
  double limit_u = 0.0; ///< no point of either surface may be further from the other, > 0 [u]
  std::stop_token stop = {};
  std::function<void(double share)> progress = {}; ///< 0..1 of the collapses of one attempt
};

} // namespace palpate
