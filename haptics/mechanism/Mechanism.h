// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/core/Types.h"
#include "haptics/mechanism/BodyMass.h"

namespace palpate
{

struct PlannedWire;
struct SidedSurface;

/// Kind of a body of a mechanism.
enum class MechanismBodyKind : std::uint8_t
{
  Held,  ///< rigid and in the hand: its frame is the hand's, turned by pose_W.q; its rod runs from the origin along +z
         ///< to its tip, or its mesh is given in that frame
  Rigid, ///< rests on others, or is joined to them, or is loose: with a mass; its frame has its centre as origin
  Soft,  ///< a soft body of the session, by its name; its frame is W, in which it is at rest
  World, ///< does not move; its frame is W; it may have a mesh
  Wire,  ///< in the hand, which pushes it out of a sheath into a vessel; the only body; its frame is W
};

[[nodiscard]] constexpr bool isInHand(MechanismBodyKind kind) noexcept
{
  return kind == MechanismBodyKind::Held || kind == MechanismBodyKind::Wire;
}

/// A body, as described by a person.
struct MechanismBody
{
  std::string name;
  MechanismBodyKind kind = MechanismBodyKind::World;
  double length_u = 0.0;   ///< of a held rod
  double diameter_u = 0.0; ///< likewise
  std::shared_ptr<const SidedSurface>
    mesh; ///< of a held body in place of a rod, of one that does not move, of one that is loose; or null
  Vec3 halfSize_u = Vec3::Zero();          ///< of a rigid box, along its own axes
  Pose pose_W;                             ///< where a rigid one is at first; how a held one is turned in the hand
  Vec3 load_W = Vec3::Zero();              ///< on a rigid one's centre, its weight say [N]
  BodyMass mass;                           ///< of a rigid one that is loose: giveMass()
  std::optional<double> friction;          ///< Coulomb's, of a mesh that does not move; none: Mechanism::foundFriction
  std::shared_ptr<const PlannedWire> wire; ///< of a wire: its plan and the answer of its check
};

/// How two bodies are joined (docs/theory.md, "Constraints between bodies"). A's motion is counted against B's.
enum class ConstraintKind : std::uint8_t
{
  Contact,     ///< A's point stays on the outer side of the plane through B's point, axis_B its normal
  Attachment,  ///< both points are one
  Hinge,       ///< and both axes have the same direction
  Slider,      ///< A's point stays on the line through B's along axis_B, and both axes have the same direction
  Break,       ///< an attachment until it is pulled at with strength_N
  Friction,    ///< a contact with Coulomb's friction
  DryFriction, ///< along axis_B a force of at most dryFriction_N, whatever else presses
  Spring,      ///< along axis_B, without force where A's point is rest_u before B's
  Limit,       ///< along axis_B A's point stays from least_u to most_u before B's, or springs back
  Puncture,    ///< A's tip meets the surface of B anywhere, goes in at strength_N, then as Insertion
  Insertion,   ///< A's shaft goes through B's point, along itself against dryFriction_N
};

/// A constraint between two bodies. Points and axes are in the frames of their bodies.
struct MechanismConstraint
{
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  std::string name;
  ConstraintKind kind = ConstraintKind::Contact;
  std::string a; ///< a body's name
  std::string b; ///< another's
  Vec3 point_A = Vec3::Zero();
  Vec3 point_B = Vec3::Zero();
  Vec3 axis_A = Vec3::UnitZ();
  Vec3 axis_B = Vec3::UnitZ();
  double strength_N = unlimited; ///< Break, Puncture: largest force
  double tear_N = unlimited;     ///< Puncture, Insertion: largest force of the hole across the shaft
  double friction = 0.0;         ///< Friction: Coulomb's coefficient; Puncture: above 0 the tip pricks, else it slides
  double dryFriction_N = 0.0;    ///< DryFriction, Puncture, Insertion
  double stiffness_N_per_u = unlimited; ///< Spring, Limit; unlimited: stiff
  double rest_u = 0.0;                  ///< Spring
  double least_u = -unlimited;          ///< Limit
  double most_u = unlimited;            ///< Limit

  friend bool operator==(const MechanismConstraint&, const MechanismConstraint&) = default;
};

/// Bodies and the constraints between them.
struct Mechanism
{
  static constexpr std::size_t mostBodies = 8;
  static constexpr std::size_t mostConstraints = 16;
  static constexpr int mostRows = 48; ///< of all constraints together

  std::vector<MechanismBody> bodies;
  std::vector<MechanismConstraint> laws;
  bool findsContacts = false; ///< of soft bodies with meshes and with one another, and of loose ones with meshes
  double foundFriction = 0.0; ///< Coulomb's coefficient there, but at meshes that have their own
  bool beginsApart = false;   ///< a soft body that lies in a mesh at rest is a fault: else both are pushed apart
};

/// The word for a kind in scene files and tables: "contact", "attachment", ... "insertion".
[[nodiscard]] const char* nameOf(ConstraintKind kind) noexcept;
/// "held", "rigid", "soft", "world", "wire".
[[nodiscard]] const char* nameOf(MechanismBodyKind kind) noexcept;
/// How many rows a constraint has where it has most.
[[nodiscard]] int mostRowsOf(ConstraintKind kind) noexcept;

/// Whether a body, as described or as planned, has a mass: it moves by the forces on it, where others are at rest in
/// each tick.
template<class Body>
[[nodiscard]] bool isLoose(const Body& body) noexcept
{
  return body.kind == MechanismBodyKind::Rigid && body.mass.mass_Ns2_per_u > 0.0;
}

/// How many bodies are of a kind.
[[nodiscard]] std::size_t countOf(const Mechanism& mechanism, MechanismBodyKind kind) noexcept;

/// Coulomb's coefficient of the contacts that are found at the mesh of a body.
[[nodiscard]] double foundFrictionOf(const Mechanism& mechanism, const MechanismBody& body) noexcept;

/// How many contacts may be found beside the constraints of a mechanism: the tick has so much room.
[[nodiscard]] int roomForFound(const Mechanism& mechanism) noexcept;

/// How the hand holds the held body: with a spring, whose compliance is in series with all others.
struct MechanismGrip
{
  double coupling_N_per_u = 0.0;
  double turning_Nu_per_rad = 0.0; ///< 0: the device leaves the turn free, and only the moments' balance turns it

  friend bool operator==(const MechanismGrip&, const MechanismGrip&) = default;
};

} // namespace palpate
