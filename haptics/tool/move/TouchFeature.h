// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/tool/certify/TrianglePair.h"
#include "haptics/tool/mesh/BoxedMesh.h"

namespace palpate
{

/// Two features that are near one another, one of the tool and one of the scene, so that their gap can be computed for
/// every pose of the tool.
struct TouchFeature
{
  enum class Kind : std::uint8_t
  {
    CornerOnFace, ///< the tool's corner, the scene's plane
    FaceOnCorner, ///< the tool's plane, the scene's corner
    EdgeOnEdge,
  };

  Kind kind = Kind::CornerOnFace;
  Vec3 point_B = Vec3::Zero();     ///< a point of the tool's feature
  Vec3 direction_B = Vec3::Zero(); ///< normal of its plane, out of the scene, or direction of its edge
  Vec3 point_W = Vec3::Zero();     ///< the same for the scene's feature
  Vec3 direction_W = Vec3::Zero();
};

/// A feature at a pose: a displacement v and a rotation w change its gap by n . (v + w x arm), to first order.
struct TouchPlane
{
  Vec3 n_W = Vec3::UnitZ();  ///< unit, from the scene to the tool
  Vec3 arm_W = Vec3::Zero(); ///< from the tool's centre to the point that touches
  double gap_u = 0.0;
};

[[nodiscard]] TouchPlane planeAt(const TouchFeature& feature, const Mat3& turn, const Vec3& centre_W) noexcept;

/// Two triangles at the pose of the tool, with the flags of their edges and corners.
struct PosedPair
{
  Corners tool_W, scene_W;
  FlatFlags toolFlat, sceneFlat;
};

/// Appends the features of two triangles that are within a distance, face to face: a corner above the inside of a face
/// or an edge across an edge. One is taken only if its normal separates the two triangles as a whole: the plane of a
/// neighbouring triangle must not stop the tool. Returns a lower bound of their distance, as far as it was computed.
double appendFeatures(
  const PosedPair& pair, const Mat3& turn, const Vec3& centre_W, double within_u, std::vector<TouchFeature>& features);

/// The plane between the nearest points, fixed in the scene: for pairs that no other plane separates.
[[nodiscard]] TouchFeature nearestFeature(
  const Corners& tool_W, const Corners& scene_W, const Mat3& turn, const Vec3& centre_W);

} // namespace palpate
