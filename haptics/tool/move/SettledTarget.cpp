// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/move/SettledTarget.h"

#include <algorithm>
#include <cmath>

#include "haptics/tool/servo/AllowedMotion.h"
#include "haptics/tool/servo/Tangents.h"

namespace palpate
{
namespace
{

constexpr int mostExchanges = 60, sweeps = 8;
constexpr double settled = 1e-11; // of the wish
/// Friction at each contact of a set, along its tangents.
using Rubbing = std::array<Eigen::Vector2d, ToolContacts::capacity>;

/// Friction for given normal forces: forces within the discs for which the motion with them is least, starting from
/// the previous ones. Returns their sum.
Vec6 rub(
  const ToolContacts& set, const AllowedMotion& pushed, const Vec6& without, double friction, Rubbing& forces) noexcept
{
  const Rubbing before = forces;
  forces.fill(Eigen::Vector2d::Zero());
  std::array<Tangents, ToolPress::most> along;
  Vec6 sum = Vec6::Zero();
  for (int k = 0; k < pushed.active; ++k)
  {
    const auto contact = static_cast<std::size_t>(pushed.presses[k].contact);
    const ToolPress& press = pushed.presses[k];
    along[k] = tangentsOf(press.n_W, press.p_W - set.pose_W.p, set.characteristic_u);
    forces[contact] = before[contact];
    sum += along[k] * forces[contact];
  }
  for (int i = 0; i < sweeps * pushed.active; ++i)
  {
    const int k = i % pushed.active;
    Eigen::Vector2d& force = forces[static_cast<std::size_t>(pushed.presses[k].contact)];
    const double largest = friction * pushed.presses[k].push_u;
    Eigen::Vector2d next = force - along[k].transpose() * (without + sum) / stiffest(along[k]);
    const double length = next.norm();
    next *= length > largest ? largest / length : 1.0;
    sum += along[k] * (next - force);
    force = next;
  }
  return sum;
}

} // namespace

SettledTarget settledTarget(const ToolContacts& set, const Vec6& wish, double friction) noexcept
{
  SettledTarget rubbed{ wish };
  if (friction <= 0.0 || set.count == 0)
  {
    return rubbed;
  }
  Rubbing forces;
  forces.fill(Eigen::Vector2d::Zero());
  while (rubbed.rounds < mostExchanges)
  {
    const AllowedMotion pushed = allowedMotion(set, rubbed.wish);
    const Vec6 pushes = pushed.y - rubbed.wish;
    const Vec6 next = wish + rub(set, pushed, wish + pushes, friction, forces);
    const double change2 = (next - rubbed.wish).squaredNorm();
    rubbed.wish = next;
    ++rubbed.rounds;
    if (change2 <= settled * settled * wish.squaredNorm())
    {
      break;
    }
  }
  return rubbed;
}

} // namespace palpate
