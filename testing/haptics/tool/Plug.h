// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// A piece of a skull and the plug of its hole, in mm: the front of a round shell about the origin, open towards -y,
/// with a hole whose border waves and gets narrower inwards.
struct PlugSize
{
  double outer_mm = 87.0, inner_mm = 79.0;
  double edge_mm = 35.0; ///< of the piece, from its axis
  double hole_mm = 12.0; ///< likewise of the hole outside, in the middle of its waves
  double wave_mm = 2.0;  ///< that it waves by, five times round
  double taper_mm = 1.5; ///< that it is narrower inside
  int around = 96;       ///< corners of a ring
};

/// The shell with its hole: closed.
[[nodiscard]] TriangleMesh shellWithHole(const PlugSize& size);
/// The plug that fills the hole but for a play all round: closed. Its pose is that in which it fits.
[[nodiscard]] TriangleMesh plugOf(const PlugSize& size, double play_mm);

} // namespace palpate::test
