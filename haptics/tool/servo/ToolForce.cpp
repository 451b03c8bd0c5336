// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/servo/ToolForce.h"

#include <algorithm>
#include <cmath>

#include "haptics/tool/solve/NearestMotion.h"

namespace palpate
{
namespace
{

/// The motion nearest to the wished one that the contacts allow, and which push. To stay where the tool is, is always
/// allowed, also where rounding leaves the solver without an answer.
Vec6 allowed(const ToolContacts& set, const Vec6& wish, ToolPull& pull) noexcept
{
  std::array<MotionRow, ToolContacts::capacity> rows;
  const std::size_t count = std::min<std::size_t>(set.count, rows.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    const ToolContact& contact = set.contacts[i];
    rows[i] = motionRow(contact.n_W, contact.arm_W, std::min(0.0, set.restGap_u - contact.gap_u), set.lever_u);
  }
  const NearestMotion nearest = nearestMotion(std::span(rows.data(), count), wish);
  if (!nearest.feasible)
  {
    return Vec6::Zero();
  }
  pull.active = nearest.count;
  for (int i = 0; i < nearest.count; ++i)
  {
    const auto row = static_cast<std::size_t>(nearest.row[i]);
    const ToolContact& contact = set.contacts[row];
    pull.presses[i] = { set.pose_W.p + contact.arm_W, contact.n_W, nearest.pressure[i] * rows[row].j.head<3>().norm() };
  }
  return nearest.y;
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
    const Vec6 y = allowed(contacts, wish, pull);
    pull.pull_u = coupling == ToolCoupling::Constraints ? Vec6(y - wish) : Vec6(-wish);
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
