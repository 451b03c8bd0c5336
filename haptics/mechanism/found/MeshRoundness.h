// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "haptics/mechanism/found/ContactFinder.h"

namespace palpate
{

/// A sphere that leaves the surface, as that is without the mesh's forces, like the mesh does around the place that is
/// nearest: by least squares over the mesh's points.
struct Roundness
{
  double radius_u = std::numeric_limits<double>::infinity(); ///< infinite where the mesh is flat
  double seen_u = 0.0;                                       ///< how far from that place gaps are known
};

/// A sphere of radius R that touches a plane at a point is h above it at a distance d where d^2 + h^2 = 2 R h.
[[nodiscard]] Roundness roundness(const std::vector<NearPlace>& near, const Pose& mesh_W, double within_u);

/// Of a mesh before a soft body, at an answer.
struct BallHistory
{
  double force_N = 0.0; ///< that it has
  double deep_u = 0.0;  ///< of its deepest place in the body without forces; below 0: before it
  double ahead_u = 0.0; ///< the same when the answer is in use, as the mesh has moved so far
};

/// Radius of the contact of a mesh that is as round as a ball of radius R as far as that goes, and as far as the
/// contact of such a ball under this force would go; none: it is not. For the force that the mesh has (Hertz), and a
/// depth d that it will have, as the radius goes with the root of d. A force under another patch is wrong by more than
/// any layer makes it: from sqrt(R d), of a half space, to sqrt(2 R d), of a thin incompressible layer.
[[nodiscard]] std::optional<double> ballContact(
  const Roundness& round, const BallHistory& history, double stiffness_N_per_u2);

} // namespace palpate
