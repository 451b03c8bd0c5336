// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "haptics/core/Types.h"

namespace palpate
{

/// So often contacts are looked for where no body is soft, as an answer then takes little work. At thirty a second a
/// hand with a ball of 5 mm would be faster than contacts are looked for from .2 m/s on.
inline constexpr double leastLooseRate_Hz = 200.0;

/// Surfaces of the scene that a person wants as loose bodies: rigid ones that have the mass of their volume.
struct LooseSources
{
  std::map<std::string, double> density_kg_per_m3; ///< by the name of the surface
  double unit_m = 0.0;                      ///< metres a unit of the scene; 0: not known, then no surface has a mass
  Vec3 gravity_m_per_s2{ 0.0, 0.0, -9.81 }; ///< in W

  /// Null: that surface is none of them.
  [[nodiscard]] const double* densityOf(const std::string& surface) const
  {
    const auto found = this->density_kg_per_m3.find(surface);
    return found != this->density_kg_per_m3.end() ? &found->second : nullptr;
  }
  friend bool operator==(const LooseSources&, const LooseSources&) = default;
};

} // namespace palpate
