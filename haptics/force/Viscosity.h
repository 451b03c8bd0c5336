// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/core/DeviceInfo.h"

namespace palpate
{

/// A handle thrown to and fro between two walls that the device or the host closes once a period. The motor's limit
/// lets the handle in deep, a held spring gives back more than it took, and a handle with little damping never comes to
/// rest.
struct Corridor
{
  double halfWidth_m = 0.0;       ///< from the middle to each wall, >= 0
  double stiffness_N_per_m = 0.0; ///< of the walls
  double maxForce_N = 0.0;        ///< of the motors, viscosity included
  double mass_kg = 0.0;           ///< of the moving part, > 0
  double damping_Ns_per_m = 0.0;  ///< its own, >= 0
  double period_s = 0.0;          ///< force held for, > 0
  double speed_m_per_s = 0.0;     ///< with which it leaves the middle
};

/// How a throw ended.
struct Throw
{
  double speed_m_per_s = 0.0; ///< the largest in the last tenth of the time
  double reach_m = 0.0;       ///< the farthest from the middle in that time
};

/// The throw simulated for so long, with exact steps of the plant between the periods and -viscosity * speed as part of
/// the held force. A bounded run: at most 1e6 periods.
[[nodiscard]] Throw throwIn(const Corridor& corridor, double viscosity_Ns_per_m, double duration_s);

/// Whether after `within_s` the handle is slower than a tenth of the speed it was thrown with.
[[nodiscard]] bool decays(const Corridor& corridor, double viscosity_Ns_per_m, double within_s = 2.0);

/// The smallest viscosity [N s/m], from above and to a twentieth of itself, with which the throw decays: with less the
/// corridor shakes, with more the maze hides behind it. 0 where none is needed, nothing where none helps. Tried upwards
/// from a ten-thousandth of mass / period, the viscosity that would stop the handle within a period.
/// Not for a tick: it simulates some dozen throws.
[[nodiscard]] std::optional<double> smallestViscosity(const Corridor& corridor, double within_s = 2.0);

/// The viscosity that a device with own walls of that stiffness needs in corridors of any width: the largest of those
/// from 0.25 to 8 mm, thrown at 0.1 m/s, its own loop at 1 kHz. A mass that is not known is taken as 50 g, a damping
/// that is not known as none. A handle that no viscosity stops gets mass / period, which stops a handle within a
/// period. Off the servo thread: some hundred throws, milliseconds.
[[nodiscard]] double corridorViscosity(const DeviceInfo& device, double stiffness_N_per_m);

} // namespace palpate
