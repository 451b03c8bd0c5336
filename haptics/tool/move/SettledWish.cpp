// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/move/SettledWish.h"

#include <algorithm>
#include <cmath>

#include "haptics/tool/servo/AllowedMotion.h"

namespace palpate
{
namespace
{

constexpr int mostExchanges = 60, sweeps = 8;
constexpr double settled = 1e-11; // of the wish
using Tangents = Eigen::Matrix<double, 6, 2>;
/// What rubs at each contact of a set, along its tangents.
using Rubbing = std::array<Eigen::Vector2d, ToolContacts::capacity>;

/// How a point of the tool goes along its contact, as columns that a whitened motion is multiplied by.
Tangents tangentsOf(const ToolPress& press, const ToolContacts& set) noexcept
{
  const Vec3 arm_W = press.p_W - set.pose_W.p;
  const Vec3 across = std::abs(press.n_W.x()) < 0.6 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
  const Vec3 first = press.n_W.cross(across).normalized(), second = press.n_W.cross(first);
  Tangents along;
  along.col(0) << first, arm_W.cross(first) / set.lever_u;
  along.col(1) << second, arm_W.cross(second) / set.lever_u;
  return along;
}

/// The larger eigenvalue of the product of the two columns: steps of its inverse never go too far.
double stiffest(const Tangents& along) noexcept
{
  const double a = along.col(0).squaredNorm(), b = along.col(1).squaredNorm(), c = along.col(0).dot(along.col(1));
  return 0.5 * (a + b + std::sqrt((a - b) * (a - b) + 4.0 * c * c));
}

/// What rubs for given pushes: forces within the discs for which the motion with them is least, sought from those of
/// before on. Returns their sum.
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
    along[k] = tangentsOf(pushed.presses[k], set);
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

SettledWish settledWish(const ToolContacts& set, const Vec6& wish, double friction) noexcept
{
  SettledWish rubbed{ wish };
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
