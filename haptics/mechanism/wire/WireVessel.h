// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "haptics/compliance/wire/WireCompliance.h"
#include "haptics/mechanism/wire/WirePlan.h"

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
  int crowded = 0; ///< beams with more triangles near than are kept: contacts may be missing
};

/// Finds where a wire touches its vessel. Each beam keeps the triangles near it with the distance for which they are
/// all; the tree is asked again when the beam has gone that far. Answers do not depend on the questions before. Some
/// 160 kB: not for the stack. Real-time safe.
class WireVessel
{
public:
  /// Of another plan nothing is kept.
  void forget() noexcept;
  /// Contacts no further apart than `reach_u`. Beams inside of the sheath, before x = 0, have none.
  void find(const WirePlan& plan, const WirePlaces& places_M, double reach_u, WireContacts& contacts) noexcept;

private:
  static constexpr int mostNear = 256;

  struct Near
  {
    std::uint32_t triangle = 0;
    float away_u = 0.0F; ///< rounded down, from the axis as it was
  };
  struct Around
  {
    bool known = false;
    int count = 0;
    double all_u = 0.0; ///< no other triangle was nearer to the axis
    Vec3 first_M = Vec3::Zero();
    Vec3 second_M = Vec3::Zero();
    std::array<Near, mostNear> near; ///< nearest first
  };
  struct Axis
  {
    Vec3 first_M; ///< clipped at the mouth
    Vec3 second_M;
    double from = 0.0; ///< share of the second node where it is clipped
  };

  [[nodiscard]] double movedSince(const Around& around, const Axis& axis) const noexcept;
  void ask(const WirePlan& plan, const Axis& axis, double reach_u, Around& around) noexcept;
  /// Has all triangles near enough around the beam, which has moved by the answer since they were asked for.
  [[nodiscard]] double look(
    const WirePlan& plan, int beam, const Axis& axis, double needed_u, WireContacts& contacts) noexcept;
  void findOf(const WirePlan& plan, int beam, const Axis& axis, double reach_u, WireContacts& contacts) noexcept;

  std::array<Around, Wire::mostBeams> around_;
  std::array<std::array<Vec3, 3>, mostNear> corners_; ///< of the triangles within reach of the beam that is looked at
};

} // namespace palpate
