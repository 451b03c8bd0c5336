// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/servo/JoinedFound.h"

#include <algorithm>
#include <limits>

#include "haptics/core/PoseMath.h"

namespace palpate
{
namespace
{

int roomFor(const FoundContacts& found, int named) noexcept
{
  return std::min(found.count, static_cast<int>(Mechanism::mostConstraints) - named);
}

/// From B's point to A's, both rigid.
Vec3 apartOf(const FoundContact& contact, const PosesOfBodies& pose_W) noexcept
{
  return pose_W[static_cast<std::size_t>(contact.mesh)] * contact.point_A -
         pose_W[static_cast<std::size_t>(contact.body)] * contact.place_B.x_W;
}

Vec3 normalOf_W(const FoundContact& contact, const PosesOfBodies& pose_W) noexcept
{
  return pose_W[static_cast<std::size_t>(contact.body)].q * contact.normal_B;
}

Vec3 across(const Vec3& way, const Vec3& normal) noexcept
{
  return way - normal.dot(way) * normal;
}

/// The one of the same name, or the nearest that presses in much the same direction; -1: none.
int sameAs(const FoundContact& contact, const FoundContacts& before, int count) noexcept
{
  int best = -1;
  double least_u = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count; ++i)
  {
    const FoundContact& other = before.contacts[static_cast<std::size_t>(i)];
    if (other.name == contact.name)
    {
      return i;
    }
    const double away_u = (other.place_B.x_W - contact.place_B.x_W).norm();
    const bool alike = other.mesh == contact.mesh && other.body == contact.body &&
                       other.normal_B.dot(contact.normal_B) > FoundContact::alike;
    if (alike && away_u <= other.apart_u && away_u < least_u)
    {
      best = i;
      least_u = away_u;
    }
  }
  return best;
}

/// A contact's state, from that of another whose points were elsewhere: the surfaces have slipped as far as before.
ConstraintState goOn(const FoundContact& contact, const FoundContact& other, const ConstraintState& before,
  const PosesOfBodies& pose_W) noexcept
{
  ConstraintState state = before;
  const Vec3 slipped_W = across(apartOf(other, pose_W) - before.stuck_u, normalOf_W(other, pose_W));
  state.stuck_u = apartOf(contact, pose_W) - across(slipped_W, normalOf_W(contact, pose_W));
  return state;
}

/// The plane of a face that meets a vertex is the mesh's own; others are the other body's, or of both.
bool turnsWithMesh(const MechanismPlan& plan, const FoundContact& contact) noexcept
{
  const bool stands = plan.bodies[static_cast<std::size_t>(contact.body)].kind == MechanismBodyKind::World;
  return contact.isAtVertexOfOther() && contact.mesh == plan.held && stands;
}

} // namespace

void joinFound(const MechanismPlan& plan, const FoundContacts& found, const PosesOfBodies& pose_W,
  MechanismPlan& joined, double rest_u) noexcept
{
  const Quat turned =
    plan.held >= 0 ? pose_W[static_cast<std::size_t>(plan.held)].q * found.held_W.q.conjugate() : Quat::Identity();
  joined = plan;
  const int count = roomFor(found, plan.lawCount);
  for (int i = 0; i < count; ++i)
  {
    const FoundContact& contact = found.contacts[static_cast<std::size_t>(i)];
    PlannedConstraint& law = joined.laws[static_cast<std::size_t>(joined.lawCount++)];
    law = {};
    law.kind = contact.friction > 0.0 ? ConstraintKind::Friction : ConstraintKind::Contact;
    law.a = contact.mesh;
    law.b = contact.body;
    law.point_A = contact.point_A;
    law.point_B = contact.place_B.x_W; // of a rigid body; on a soft one place_B is
    law.axis_B = turnsWithMesh(plan, contact) ? Vec3(turned * contact.normal_B) : contact.normal_B;
    law.friction = contact.friction;
    law.place_A = contact.place_A;
    law.place_B = contact.place_B;
    const bool stands = plan.bodies[static_cast<std::size_t>(contact.body)].kind == MechanismBodyKind::World;
    if (rest_u > 0.0 && contact.mesh == plan.held && stands)
    {
      law.point_B += rest_u * law.axis_B;
    }
  }
}

void takeFound(const FoundContacts& found, int named, const PosesOfBodies& pose_W, MechanismState& state) noexcept
{
  const auto before = state.laws;
  const int had = roomFor(state.found, named);
  std::array<bool, FoundContacts::most> taken{};
  for (int i = 0; i < roomFor(found, named); ++i)
  {
    const FoundContact& contact = found.contacts[static_cast<std::size_t>(i)];
    ConstraintState& law = state.laws[static_cast<std::size_t>(named + i)];
    const int same = sameAs(contact, state.found, had);
    law = {};
    if (same >= 0)
    {
      law = goOn(contact, state.found.contacts[static_cast<std::size_t>(same)],
        before[static_cast<std::size_t>(named + same)], pose_W);
      if (taken[static_cast<std::size_t>(same)])
      {
        law.force_W.setZero(); // it is only a first guess, and is counted once
      }
      taken[static_cast<std::size_t>(same)] = true;
    }
    law.place_A = contact.place_A;
    law.place_B = contact.place_B;
  }
  for (std::size_t l = static_cast<std::size_t>(named + roomFor(found, named)); l < state.laws.size(); ++l)
  {
    state.laws[l] = {};
  }
  state.found = found;
}

} // namespace palpate
