// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <type_traits>

#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

struct MechanismBody;

/// Mass and inertia of a rigid body about its centre, so that a force [N] on it is the mass times the acceleration in
/// scene units: kilograms times metres a unit.
struct BodyMass
{
  double mass_Ns2_per_u = 0.0;        ///< 0: none, the body is at rest in each tick
  Mat3 inertia_N_s2_u = Mat3::Zero(); ///< in the body's frame, symmetric, positive definite

  friend bool operator==(const BodyMass&, const BodyMass&) = default;
};

/// Whether a mass is none, or a force moves a body that has it: above 0, and the inertia symmetric and positive
/// definite.
[[nodiscard]] bool isValid(const BodyMass& mass);

template<class Visit, class Mass>
void membersOf(const Visit& visit, Mass& mass) requires std::is_same_v<std::remove_const_t<Mass>, BodyMass>
{
  visit(mass.mass_Ns2_per_u);
  for (auto column : mass.inertia_N_s2_u.colwise())
  {
    std::ranges::for_each(column, visit);
  }
}

/// The volume in a closed surface, by integrals over its triangles.
struct EnclosedVolume
{
  double volume_u3 = 0.0;
  Vec3 centre_u = Vec3::Zero();
  Mat3 second_u5 = Mat3::Zero(); ///< integral of x x^T about the centre
};

/// Of triangles that are right-handed about the outer normal.
[[nodiscard]] EnclosedVolume enclosedBy(const TriangleMesh& mesh);

/// A box of these half sizes about the origin: 12 triangles, right-handed about the outer normal.
[[nodiscard]] TriangleMesh boxOf(const Vec3& halfSize_u);

/// Gives a rigid box, or a rigid mesh, the mass that its volume has at a density [kg/m^3] at `unit_m` metres a unit. A
/// box gets the mesh of its surface, so that its contacts are found; the frame of a mesh goes to its centre, and the
/// pose with it. Returns the new origin in the old frame, or a refusal. Not real-time safe.
struct MassGiven
{
  Vec3 centre_u = Vec3::Zero();
  std::string refusal; ///< a sentence without an end; "": none
};
[[nodiscard]] MassGiven giveMass(MechanismBody& body, double density_kg_per_m3, double unit_m);

} // namespace palpate
