// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// How a surface is to be touched, as far as the fineness of its mesh matters.
struct TouchConditions
{
  double scale_u_per_m = 1.0;        ///< scene units per metre of the hand, > 0
  double penetration_m = 1e-3;       ///< how deep the hand presses, > 0
  double stiffness_N_per_m = 1000.0; ///< >= 0
  double resolution_m = 0.0;         ///< smallest motion the device tells apart; 0: not known
};

/// Deviation of a mesh's facets from a smooth surface through its vertices, and its perceptibility.
///
/// Each triangle's curvature comes from the dihedral angles at its edges. At an edge the normal has turned from that of
/// one face towards that of the other, in proportion to how far each face reaches; the change of the normal from edge
/// to edge is the second fundamental form. A quadratic through the corners then stands furthest off the triangle by the
/// sagitta. Edges sharper than 30 degrees are taken to be meant, and so are free edges and those of more than two
/// triangles: nothing is known of a smooth surface across them.
struct ScenePlan
{
  TouchConditions conditions;
  std::size_t triangles = 0;
  std::size_t sharpEdges = 0;      ///< edges sharper than 30 degrees
  double deviation_u = 0.0;        ///< largest sagitta in the scene
  double deviation_m = 0.0;        ///< the same at the hand
  double forceError = 0.0;         ///< relative, at the penetration: deviation / penetration
  bool felt = false;               ///< above `noticed` and above the resolution of the device
  std::size_t trianglesNeeded = 0; ///< this number of triangles, spread alike, makes the deviation imperceptible

  /// Difference in force a hand just notices, relative.
  static constexpr double noticed = 0.07;

  /// So far a surface may be from another one before a hand tells them apart [u].
  [[nodiscard]] double unnoticed_u() const;

  /// "pressed 1 mm deep at 1000 N/m, facets change the force by up to 5.7 % (...)": for a person, with units.
  [[nodiscard]] std::string sentence() const;
};

/// Plans a touch of this surface; of curves, which have no facets, with none. Off the servo thread; O(triangles).
/// Throws std::invalid_argument for conditions that are not finite or not in the ranges given.
[[nodiscard]] ScenePlan planTouch(const SurfaceTree& surface, const TouchConditions& conditions);

} // namespace palpate
