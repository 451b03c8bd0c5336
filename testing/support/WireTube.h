// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "haptics/mechanism/wire/WireTick.h"

namespace palpate::test
{

/// A tube whose centre line begins before the origin, runs along x to it and on, bends in an arc towards y, and runs
/// straight on. Its triangles have their corners on the tube. Units: mm, N.
struct Tube
{
  double radius_mm = 1.0;
  double before_mm = 5.0; ///< behind the origin, where the sheath ends
  double first_mm = 40.0;
  double bend_mm = 25.0; ///< radius of the centre line
  double angle_rad = 0.0;
  double last_mm = 0.0;
  bool blind = false; ///< closed by a fan at its end
  int around = 32;
  double ring_mm = 1.0;

  [[nodiscard]] Vec3 centre_mm(double s_mm) const;
  [[nodiscard]] double length_mm() const { return this->first_mm + this->bend_mm * this->angle_rad + this->last_mm; }
  [[nodiscard]] TriangleMesh mesh() const;
};

/// A wire of .5 mm, 60 GPa, straight, in mm and N.
[[nodiscard]] WireDescription nitinolWire(double length_mm, int beams, double friction);

/// A wire that is pushed into a vessel without a device, a tick a millisecond.
class PushedWire
{
public:
  PushedWire(const WireDescription& description, const TriangleMesh& vessel_mm);

  /// One tick, with the hand so far along the sheath.
  const WireResult& tick(double hand_mm, double turn_rad = 0.0);

  double coupling_N_per_mm = 1.0;
  double turning_Nmm_per_rad = 0.0;
  std::uint32_t budget = std::numeric_limits<std::uint32_t>::max(); ///< of a tick
  PlannedWire planned;
  WireTick ticks;
};

/// The smallest distance of the wire's centre line outside of the sheath from the vessel, by all triangles and places a
/// tenth of a beam apart.
[[nodiscard]] double nearestWall_mm(const WirePlan& plan, const WireState& state);

} // namespace palpate::test
