// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/DeviceInfo.h"

namespace palpate
{

/// What a device is believed to hold by itself. A descriptor only offers: firmwares are known whose walls pull the hand
/// through, or do nothing. So it is believed once a hand has felt it, and not before.
struct HeldTrust
{
  bool walls = false;  ///< pushes back from either side of each axis
  bool damper = false; ///< brakes in both directions
  friend bool operator==(const HeldTrust&, const HeldTrust&) = default;
};

/// Of what a device offers, what it is believed.
[[nodiscard]] constexpr DeviceAbilities believed(DeviceAbilities offered, HeldTrust trust) noexcept
{
  offered.holdsWalls = offered.holdsWalls && trust.walls;
  offered.viscous = offered.viscous && trust.damper;
  return offered;
}

/// A device that may hold walls and brake by itself.
class WallHolder
{
public:
  virtual ~WallHolder() = default;

  /// What it is believed from now on; what it is not is left to the host: walls become forces, viscosity nothing. Any
  /// thread, but not while another one reads the device's info.
  virtual void trust(HeldTrust trust) noexcept = 0;
  /// What it offers, believed or not.
  [[nodiscard]] virtual DeviceAbilities offered() const = 0;
};

} // namespace palpate
