// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// Where a mesh around the origin, inscribed in a sphere, is furthest from that sphere. Lengths in scene units.
struct WorstFacets
{
  Vec3 faceNormal = Vec3::UnitZ(); ///< outward normal of the face whose plane is nearest to the origin
  double faceRadius_u = 1e300;     ///< and the distance of that plane
  Vec3 edgeMiddle = Vec3::Zero();  ///< of the sharpest edge
  Vec3 edgeAcross = Vec3::UnitX(); ///< unit, crosses that edge along the surface
  double edgeAngle_rad = 0.0;      ///< between the normals of its two faces
};

[[nodiscard]] WorstFacets worstOf(const TriangleMesh& mesh);

} // namespace palpate::test
