// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/servo/ToolForce.h"

#include <cmath>

#include "haptics/tool/servo/FrictionTarget.h"

namespace palpate
{

ToolPull toolPull(const ToolContacts& contacts, const Pose& device_W, ToolCoupling coupling, double friction) noexcept
{
  ToolPull pull;
  const double length2 = device_W.q.squaredNorm();
  if (contacts.placed && device_W.p.allFinite() && std::abs(length2 - 1.0) < 1e-6)
  {
    bool cut = false;
    const Vec6 wish = wishedMotion(contacts.pose_W, device_W, contacts.characteristic_u, cut);
    const bool rubs = coupling == ToolCoupling::Constraints; // the virtual spring is the same with friction
    const AllowedMotion allowed = allowedMotion(contacts, rubs ? frictionTarget(contacts, wish, friction) : wish);
    pull.active = allowed.active;
    pull.presses = allowed.presses;
    pull.pull_u = coupling == ToolCoupling::Constraints ? Vec6(allowed.y - wish) : Vec6(-wish);
  }
  return pull;
}

ToolPush toolPush(const ToolContacts& contacts, const Pose& device_W, double stiffness_N_per_u, ToolCoupling coupling,
  double friction) noexcept
{
  const ToolPull pull = toolPull(contacts, device_W, coupling, friction);
  ToolPush push;
  push.active = pull.active;
  push.stored = 0.5 * stiffness_N_per_u * pull.pull_u.squaredNorm();
  push.wrench_W.force = stiffness_N_per_u * pull.pull_u.head<3>();
  push.wrench_W.torque = stiffness_N_per_u * contacts.characteristic_u * pull.pull_u.tail<3>();
  return push;
}

} // namespace palpate
