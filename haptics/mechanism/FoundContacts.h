// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "haptics/compliance/snapshot/ComplianceSnapshot.h"
#include "haptics/mechanism/Mechanism.h"

namespace palpate
{

/// A contact of a rigid mesh with a soft body, or with another mesh, or of two soft bodies, that nobody has named: the
/// mesh's point stays on the outer side of the plane through the other body's. The plane is in the other body's frame,
/// which is W but for a body that moves. Of two soft bodies, the surface of the first one is the mesh.
struct FoundContact
{
  static constexpr double alike = 0.9; ///< cosine between the normals of contacts that press in much the same direction

  std::uint64_t name = 0;        ///< of the features that meet: the same from answer to answer
  std::int32_t mesh = 0;         ///< the body with the mesh, in the plan
  std::int32_t body = 0;         ///< the other one
  Vec3 point_A = Vec3::Zero();   ///< of the mesh, in its frame
  SurfacePoint place_A;          ///< likewise, of a soft body's surface: point_A is where it is free
  SurfacePoint place_B;          ///< of the other body
  Vec3 normal_B = Vec3::UnitZ(); ///< out of the other body, in its frame
  double apart_u = 0.0;          ///< other contacts in this direction are as far away, or further
  double friction = 0.0;         ///< Coulomb's

  [[nodiscard]] bool isAtVertexOfOther() const noexcept
  {
    return this->place_B.vertices[0] == this->place_B.vertices[1];
  }
};

template<class Visit, class Contact>
void membersOf(const Visit& visit, Contact& found) requires std::is_same_v<std::remove_const_t<Contact>, FoundContact>
{
  visit(found.name);
  visit(found.mesh);
  visit(found.body);
  visit(found.point_A);
  visit(found.place_A);
  visit(found.place_B);
  visit(found.normal_B);
  visit(found.apart_u);
  visit(found.friction);
}

/// An answer of the finder. Of fixed size, so that the tick keeps a copy.
struct FoundContacts
{
  static constexpr int most = static_cast<int>(Mechanism::mostConstraints);

  std::uint64_t answer = 0; ///< another one for each; 0: none
  double reach_u = 0.0;     ///< so far the mesh in the hand may go until the next answer; infinite without such a mesh
  Pose held_W;              ///< of that mesh, when they were looked for
  std::int32_t count = 0;
  std::int32_t leftOut = 0; ///< places where the mesh touches, or nearly, for which a tick has no room
  std::array<FoundContact, most> contacts{};
};

template<class Visit, class Contacts>
void membersOf(
  const Visit& visit, Contacts& found) requires std::is_same_v<std::remove_const_t<Contacts>, FoundContacts>
{
  visit(found.answer);
  visit(found.reach_u);
  visit(found.held_W);
  visit(found.count);
  visit(found.leftOut);
  visit(found.contacts);
}

} // namespace palpate
