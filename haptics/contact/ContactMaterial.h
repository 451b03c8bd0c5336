// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/FeatureGeometry.h"
#include "haptics/contact/PosedSurface.h"

namespace palpate
{

/// What a surface is made of where it is touched.
struct ContactMaterial
{
  double stiffnessFactor = 1.0;
  FrictionPlan friction;
  double height_u = 0.0;                ///< of its texture
  Vec3 slope_W = Vec3::Zero();          ///< gradient of the height along the surface
  double grain_u = 0.0;                 ///< shortest side of the face: no texture is finer
};

/// Material of feature f at the foot of the ball: fields are linear over a face and along an edge (there without a slope
/// across it); where a surface has none, its own value, and where it has none of its own, the plan's.
template<class SceneView>
[[nodiscard]] ContactMaterial materialAt(
  const SceneView& scene, const ContactPlan& plan, const ActiveFeature& f, const Vec3& foot_W) noexcept;

} // namespace palpate
