// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "haptics/mechanism/wire/BeamContacts.h"
#include "haptics/mechanism/wire/WirePlan.h"

namespace palpate
{

/// How far from the skin contacts are looked for.
struct WireReach
{
  double shaft_u = 0.0;
  double tip_u = 0.0; ///< of the last beam, which goes on to where no beam was
};

/// Finds where a wire touches its vessel. Each beam keeps the triangles near its line, with bounds of their distances
/// that a motion of the beam lessens; the tree is asked again when the bounds are used up. Answers do not depend on the
/// questions before. Some 600 kB: not for the stack. Real-time safe.
class WireVessel
{
public:
  /// Of another plan nothing is kept.
  void forget() noexcept;
  /// Contacts no further apart than the reach. Beams inside of the sheath, before x = 0, have none.
  void find(const WirePlan& plan, const WirePlaces& places_M, const WireReach& reach, WireContacts& contacts) noexcept;

private:
  static constexpr int mostKept = 512; ///< around the line of a beam

  /// Bounds, rounded so that they stay true.
  struct Near
  {
    std::uint32_t triangle = 0;
    float away_u = 0.0F; ///< of the distance from the line
    float low_u = 0.0F;  ///< interval along the line
    float high_u = 0.0F;
  };
  /// Around a line, which goes on beyond both ends of the beam as it was: a beam that slides along itself stays on it.
  struct Around
  {
    bool known = false;
    bool crowded = false; ///< the beam alone has more triangles than are looked at, as it was seen last
    int count = 0;
    double all_u = 0.0; ///< no other triangle is nearer to the line, between the places `low_u` and `high_u` on it
    double low_u = 0.0;
    double high_u = 0.0;
    Vec3 from_M = Vec3::Zero();
    Vec3 along_M = Vec3::UnitX();    ///< unit
    std::array<Near, mostKept> near; ///< in no order
  };
  struct Axis
  {
    Vec3 first_M; ///< clipped at the mouth
    Vec3 second_M;
    double from = 0.0; ///< share of the second node where it is clipped
  };
  /// A beam beside the line of its list.
  struct Beside
  {
    double first_u = 0.0; ///< along the line
    double second_u = 0.0;
    double firstOff_u = 0.0; ///< from the line
    double secondOff_u = 0.0;
  };

  [[nodiscard]] static Beside besideOf(const Around& around, const Axis& axis) noexcept;
  /// How far the beam can go before its list is used up; below 0: it is.
  [[nodiscard]] static double leftOf(const Around& around, const Beside& beside, double needed_u) noexcept;
  void askAroundLine(const WirePlan& plan, int beam, const Axis& axis, double needed_u, Around& around) noexcept;
  [[nodiscard]] bool gatherFromLine(
    const WirePlan& plan, int beam, const Axis& axis, double needed_u, WireContacts& contacts) noexcept;
  [[nodiscard]] double gatherAroundBeam(
    const WirePlan& plan, const Axis& axis, double needed_u, Around& around) noexcept;
  void findOf(const WirePlan& plan, int beam, const Axis& axis, double reach_u, WireContacts& contacts) noexcept;

  std::array<Around, Wire::mostBeams> around_;
  BeamTriangles looked_; ///< within reach of the beam that is looked at
  BeamScratch room_;
  double leastLeft_u_ = 0.0; ///< of the lists
  int soonest_ = 0;          ///< the beam whose list is that
  double nodeAway_u_ = 0.0;  ///< of the wall from the node between the beam before and the next; not a number: unknown
};

} // namespace palpate
