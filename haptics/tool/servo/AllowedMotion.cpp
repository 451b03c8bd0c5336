// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/servo/AllowedMotion.h"

#include <algorithm>

#include "haptics/tool/solve/NearestMotion.h"

namespace palpate
{

AllowedMotion allowedMotion(const ToolContacts& set, const Vec6& wish) noexcept
{
  std::array<MotionRow, ToolContacts::capacity> rows;
  const std::size_t count = std::min<std::size_t>(set.count, rows.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    const ToolContact& contact = set.contacts[i];
    rows[i] = motionRow(contact.n_W, contact.arm_W, std::min(0.0, set.restGap_u - contact.gap_u), set.characteristic_u);
  }
  const NearestMotion nearest = nearestMotion(std::span(rows.data(), count), wish);
  AllowedMotion allowed;
  if (!nearest.feasible)
  {
    return allowed;
  }
  allowed.y = nearest.y;
  allowed.active = nearest.count;
  for (int i = 0; i < nearest.count; ++i)
  {
    const auto row = static_cast<std::size_t>(nearest.row[i]);
    const ToolContact& contact = set.contacts[row];
    const double push_u = nearest.pressure[i] * rows[row].j.head<3>().norm();
    allowed.presses[i] = { set.pose_W.p + contact.arm_W, contact.n_W, push_u, nearest.row[i] };
  }
  return allowed;
}

} // namespace palpate
