// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "devices/simulated/DeviceModels.h"
#include "devices/simulated/FrictionPlant.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// A moving part at one place: along its principal directions it moves as decoupled masses.
struct PrincipalPart
{
  Mat3 directions_D = Mat3::Identity(); ///< columns; the first `count` are directions in which the part moves
  int count = 3;
  Vec3 mass_kg = Vec3::Zero();          ///< apparent
  Vec3 damping_Ns_per_m = Vec3::Zero(); ///< along each
  Vec3 friction_N = Vec3::Zero();       ///< Coulomb, in a motion along each
  Mat3 dampingAcross = Mat3::Zero();    ///< damping that couples the directions [N s/m]
};

/// Such a part in a hand: the motion over a period is exact along each direction (FrictionPlant), under the damping
/// across the directions at the beginning.
class PrincipalPlant
{
public:
  /// Mass of part and hand above zero, period [s] above zero.
  PrincipalPlant(const PrincipalPart& part, const HandModel& hand, double period_s);

  /// One period under a force of hand and motors [N]. Real-time safe.
  void step(Vec3& p_D, Vec3& v_D, const Vec3& force_N) const noexcept;

private:
  PrincipalPart part_;
  std::array<FrictionPlant, 3> axes_;
};

} // namespace palpate
