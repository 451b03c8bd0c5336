// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/path/TickCost.h"

#include <algorithm>
#include <array>

namespace palpate
{

TickCost::TickCost()
{
  std::array<double, 1001> empty{};
  for (double& cost : empty)
  {
    this->start();
    cost = this->cost_us();
  }
  auto* const middle = empty.begin() + empty.size() / 2;
  std::nth_element(empty.begin(), middle, empty.end());
  this->overhead_us_ = *middle;
}

double TickCost::cost_us() const
{
  constexpr double usPerNs = 1e-3;
  const double elapsed_us = static_cast<double>(this->clock_.now_ns() - this->start_ns_) * usPerNs;
  return std::max(0.0, elapsed_us - this->overhead_us_);
}

} // namespace palpate
