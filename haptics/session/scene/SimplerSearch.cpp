// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/scene/SimplerSearch.h"

#include <utility>

#include "haptics/contact/RadiusLimit.h"

namespace palpate
{

bool SimplerSearch::follow(std::shared_ptr<const Scene> full, std::vector<SurfaceChoice> choices,
  const SimplifyRules& rules, std::uint64_t revision)
{
  this->task_.cancel();
  return this->task_.want(
    [this, order = Order{ std::move(full), std::move(choices), rules, revision }](const std::stop_token& stop) mutable
    {
      order.rules.stop = stop;
      const bool known = this->simplifier_.knows(*order.full, order.choices, order.rules);
      auto look = [this, order = std::move(order)]() mutable { return this->look(std::move(order)); };
      return LatestTask<FoundScene>::Work{ std::move(look), known };
    });
}

FoundScene SimplerSearch::look(Order order)
{
  FoundScene found{ this->simplifier_.simplify(*order.full, std::move(order.choices), order.rules, order.revision) };
  found.largestRadius_u = found.scene ? radiusLimit(*found.scene, {}).largest_u : 0.0;
  return found;
}

} // namespace palpate
