// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/servo/ToolForce.h"

#include <algorithm>
#include <cmath>

#include "haptics/tool/solve/NearestMotion.h"

namespace palpate
{
namespace
{

/// The motion nearest to the wished one that the contacts allow. To stay where the tool is, is always allowed, also
/// where rounding leaves the solver without an answer.
NearestMotion allowed(const ToolContacts& set, const Vec6& wish) noexcept
{
  std::array<MotionRow, ToolContacts::capacity> rows;
  const std::size_t count = std::min<std::size_t>(set.count, rows.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    const ToolContact& contact = set.contacts[i];
    rows[i] = motionRow(contact.n_W, contact.arm_W, std::min(0.0, set.restGap_u - contact.gap_u), set.lever_u);
  }
  const NearestMotion nearest = nearestMotion(std::span(rows.data(), count), wish);
  return nearest.feasible ? nearest : NearestMotion{};
}

} // namespace

ToolPull toolPull(const ToolContacts& contacts, const Pose& device_W, ToolCoupling coupling) noexcept
{
  ToolPull pull;
  const double length2 = device_W.q.squaredNorm();
  if (contacts.placed && device_W.p.allFinite() && std::abs(length2 - 1.0) < 1e-6)
  {
    bool cut = false;
    const Vec6 wish = wishedMotion(contacts.pose_W, device_W, contacts.lever_u, cut);
    const NearestMotion nearest = allowed(contacts, wish);
    pull.active = nearest.count;
    pull.pull_u = coupling == ToolCoupling::Constraints ? Vec6(nearest.y - wish) : Vec6(-wish);
  }
  return pull;
}

ToolPush toolPush(
  const ToolContacts& contacts, const Pose& device_W, double stiffness_N_per_u, ToolCoupling coupling) noexcept
{
  const ToolPull pull = toolPull(contacts, device_W, coupling);
  ToolPush push;
  push.active = pull.active;
  push.stored = 0.5 * stiffness_N_per_u * pull.pull_u.squaredNorm();
  push.wrench_W.force = stiffness_N_per_u * pull.pull_u.head<3>();
  push.wrench_W.torque = stiffness_N_per_u * contacts.lever_u * pull.pull_u.tail<3>();
  return push;
}

} // namespace palpate
