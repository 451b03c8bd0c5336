// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/servo/FrictionTarget.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/tool/servo/Tangents.h"

namespace palpate
{
namespace
{

constexpr int mostSweeps = 12;
constexpr double settled = 1e-4; // of the wish
constexpr double beyond = 1.3;   // over-relaxation: where all contacts stick half the sweeps are enough

/// A contact and its force. The columns multiply whitened motions.
struct RubbingContact
{
  Vec6 normal;
  Tangents along;
  double least_u;   ///< least motion of the point along the normal
  double normal2;   ///< steps of its inverse meet the bound at once
  double stiffest2; ///< largest eigenvalue of the tangents' product: steps of its inverse never overshoot
  double push_u;    ///< normal force over the stiffness
  Eigen::Vector2d rub_u;
};

RubbingContact rubbingContact(const ToolContact& contact, const ToolContacts& set) noexcept
{
  const Vec3& n_W = contact.n_W;
  RubbingContact rubbing;
  rubbing.normal << n_W, contact.arm_W.cross(n_W) / set.characteristic_u;
  rubbing.along = tangentsOf(n_W, contact.arm_W, set.characteristic_u);
  rubbing.least_u = std::min(0.0, set.restGap_u - contact.gap_u);
  rubbing.normal2 = rubbing.normal.squaredNorm();
  rubbing.stiffest2 = stiffest(rubbing.along);
  rubbing.push_u = 0.0;
  rubbing.rub_u = Eigen::Vector2d::Zero();
  return rubbing;
}

/// Changes the normal force until the gap is kept, and the motion with it.
void push(RubbingContact& contact, Vec6& motion) noexcept
{
  const double short_u = contact.least_u - contact.normal.dot(motion);
  const double push_u = std::max(0.0, contact.push_u + beyond * short_u / contact.normal2);
  motion += (push_u - contact.push_u) * contact.normal;
  contact.push_u = push_u;
}

/// Changes the friction towards rest, and with it the motion and the target motion.
void rub(RubbingContact& contact, double friction, Vec6& motion, Vec6& rubbed) noexcept
{
  const double largest_u = friction * contact.push_u;
  Eigen::Vector2d rub_u = contact.rub_u - beyond * contact.along.transpose() * motion / contact.stiffest2;
  const double length2 = rub_u.squaredNorm();
  if (length2 > largest_u * largest_u)
  {
    rub_u *= largest_u / std::sqrt(length2);
  }
  const Vec6 change = contact.along * (rub_u - contact.rub_u);
  motion += change;
  rubbed += change;
  contact.rub_u = rub_u;
}

} // namespace

Vec6 frictionTarget(const ToolContacts& set, const Vec6& wish, double friction) noexcept
{
  std::array<RubbingContact, ToolContacts::capacity> contacts;
  const std::size_t count = friction > 0.0 ? std::min<std::size_t>(set.count, contacts.size()) : 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    contacts[i] = rubbingContact(set.contacts[i], set);
  }
  Vec6 rubbed = wish, motion = wish;
  bool moved = count > 0;
  for (int sweep = 0; moved && sweep < mostSweeps; ++sweep)
  {
    const Vec6 before = motion;
    for (std::size_t i = 0; i < count; ++i)
    {
      push(contacts[i], motion);
      if (contacts[i].push_u > 0.0 || contacts[i].rub_u != Eigen::Vector2d::Zero())
      {
        rub(contacts[i], friction, motion, rubbed);
      }
    }
    moved = (motion - before).squaredNorm() > settled * settled * wish.squaredNorm();
  }
  return rubbed;
}

} // namespace palpate
