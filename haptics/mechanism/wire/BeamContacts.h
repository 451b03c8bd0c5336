// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "haptics/compliance/wire/WireCompliance.h"
#include "haptics/mechanism/wire/SegmentDistance.h"

namespace palpate
{

/// A place where a beam is near the wall, on the wire as it is.
struct WireContact
{
  int beam = 0;
  double share = 0.0;            ///< of the beam's second node
  double gap_u = 0.0;            ///< between the wire's skin and the wall; below 0: the skin is in the wall
  Vec3 at_M = Vec3::Zero();      ///< on the wall
  Vec3 normal_M = Vec3::UnitZ(); ///< from the wall to the centre line
};

/// Where the wire touches, or nearly.
struct WireContacts
{
  static constexpr int mostOfBeam = 5; ///< two between its nodes, three at the second: a tick solves those that press
  static constexpr int mostFound = mostOfBeam * Wire::mostBeams;

  int count = 0;
  std::array<WireContact, mostFound> all{};     ///< in the order of the beams, then along each
  std::array<double, Wire::mostBeams> away_u{}; ///< no wall is nearer to the axis of this beam outside of the sheath
  int queries = 0;                              ///< of the tree, for this answer
  int looked = 0;                               ///< at triangles: distances from a beam or its nodes
  int crowded = 0; ///< beams with more triangles near than are kept: contacts may be missing
};

/// The part of a beam outside of the sheath.
struct BeamPlace
{
  double radius_u = 0.0;
  double reach_u = 0.0; ///< of contacts, from the skin
  int beam = 0;
  Vec3 first_M; ///< of the axis, clipped at the mouth
  Vec3 second_M;
  double from = 0.0; ///< share of the second node where it is clipped
};

/// A triangle near a beam, with lower bounds of distances from the axis.
struct BeamTriangle
{
  std::array<Vec3, 3> corner_M;
  const Vec3* normal_M; ///< of its plane
  std::uint32_t owned;  ///< FacePlane's: of an edge between two triangles one owns it
  double away_u;        ///< of the beam
  double first_u;       ///< of its first node
  double second_u;      ///< of its second node
};

/// At least all triangles whose distance from the axis is within radius and reach, in any order.
struct BeamTriangles
{
  static constexpr int most = 256;

  int count = 0;
  std::array<BeamTriangle, most> all;
};

/// Workspace of addContactsOfBeam().
struct BeamScratch
{
  int ends = 0;
  std::array<WireContact, BeamTriangles::most> end;
  int betweens = 0;
  std::array<SegmentPair, std::size_t{ 3 } * BeamTriangles::most> between;
};

/// Adds the contacts of a beam within reach, and brings its `away_u` down to the distance of its axis from the wall.
/// The answer is that of all triangles within radius and reach, whatever the bounds. `nodeAway_u`: of the wall from the
/// first node, if it is known, infinite beyond reach, or not a number; then that from the second. Real-time safe.
void addContactsOfBeam(const BeamPlace& beam, const BeamTriangles& near, BeamScratch& room, WireContacts& contacts,
  double& nodeAway_u) noexcept;

} // namespace palpate
