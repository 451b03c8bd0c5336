// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// A hand that puts an implant where it fits, leaves it there for a second, and then draws, presses and turns it about
/// for good. Both are given in mm as they lie when it fits; it comes from -y.
struct ImplantTask
{
  TriangleMesh bone, implant;
  double seconds = 4.0;
  int judgedEach = 20; ///< ticks: of so many the recorded pose is judged
};

/// The result.
struct ImplantFigures
{
  std::uint64_t ticks = 0, touching = 0;
  double pressed_N = 0.0;                  ///< the largest force
  double step_N = 0.0;                     ///< by which it changes most in a tick
  double excess_J = 0.0;                   ///< that the hand got beyond the energy of the touched spring
  double seatedOff_mm = 0.0;               ///< of the implant from where it fits, after its second of rest
  std::uint64_t judged = 0, crossings = 0; ///< poses of the recording, pairs of triangles that meet there, exactly
  std::string problem;                     ///< a fault, or that of a replay with one, two or four workers
};

/// In virtual time, in the hand of a simulated device with six axes; recorded and replayed.
[[nodiscard]] ImplantFigures playImplant(const ImplantTask& task);

/// In a line.
[[nodiscard]] std::string describe(const ImplantFigures& figures);

} // namespace palpate::test
