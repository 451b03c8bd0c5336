// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/DeviceInfo.h"

namespace palpate
{

/// Trusted conditions in the device's own loop. A descriptor only offers: firmwares are known whose walls pull the hand
/// through, or do nothing. So it is believed once a hand has felt it, and not before.
struct HeldTrust
{
  bool walls = false;  ///< pushes back from either side of each axis
  bool damper = false; ///< brakes in both directions
  friend bool operator==(const HeldTrust&, const HeldTrust&) = default;
};

/// The trusted part of a device's offers.
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

  /// The trusted part from now on; the rest is left to the host: walls become forces, viscosity nothing. Any
  /// thread, but not while another one reads the device's info.
  virtual void trust(HeldTrust trust) noexcept = 0;
  /// Its offers, trusted or not.
  [[nodiscard]] virtual DeviceAbilities offered() const = 0;
};

} // namespace palpate
