// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/inputs/Tools.h"

#include <cmath>

namespace palpate
{
namespace
{

template<class Io, class T>
void layContacts(const Io& io, T& set)
{
  io(set.revision);
  io(set.held);
  io(set.placed);
  io(set.pose_W);
  io(set.characteristic_u);
  io(set.restGap_u);
}

template<class Io, class T>
void layContact(const Io& io, T& contact)
{
  io(contact.n_W);
  io(contact.arm_W);
  io(contact.gap_u);
}

constexpr std::size_t bytesOfContact = 7 * sizeof(double);

/// Far more than turns and sums of rounding leave, far less than would be felt.
constexpr double offUnit = 1e-6;
constexpr double leastLever_u = 1e-12; // turns are divided by it

bool isUsable(const ToolContacts& set)
{
  return set.pose_W.p.allFinite() && std::abs(set.pose_W.q.norm() - 1.0) <= offUnit && std::isfinite(set.restGap_u) &&
         set.characteristic_u >= leastLever_u && std::isfinite(set.characteristic_u);
}

bool isUsable(const ToolContact& contact)
{
  return std::abs(contact.n_W.norm() - 1.0) <= offUnit && contact.arm_W.allFinite() && std::isfinite(contact.gap_u);
}

} // namespace

void putTool(ByteWriter& payload, const ToolContacts& contacts)
{
  layContacts(Put{ payload }, contacts);
  payload.put(static_cast<std::uint64_t>(contacts.count));
  for (std::uint32_t i = 0; i < contacts.count; ++i)
  {
    layContact(Put{ payload }, contacts.contacts[i]);
  }
  payload.put(contacts.ball_u);
  payload.put(contacts.reach_u);
}

ToolContacts readTool(ByteReader& in)
{
  ToolContacts set;
  layContacts(Get{ in }, set);
  const std::uint64_t count = in.count(bytesOfContact);
  in.failUnless(count <= ToolContacts::capacity && isUsable(set));
  for (std::uint64_t i = 0; i < count && in.ok(); ++i)
  {
    layContact(Get{ in }, set.contacts[i]);
    in.failUnless(isUsable(set.contacts[i]));
  }
  set.count = static_cast<std::uint32_t>(in.ok() ? count : 0);
  in.get(set.ball_u);
  in.get(set.reach_u);
  in.failUnless(set.ball_u >= 0.0 && std::isfinite(set.ball_u) && set.reach_u >= 0.0 && std::isfinite(set.reach_u));
  return set;
}

} // namespace palpate
