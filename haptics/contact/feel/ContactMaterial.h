// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/planes/FeatureGeometry.h"
#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/geometry/mesh/Material.h"

namespace palpate
{

/// The material of a surface at the contact.
struct ContactMaterial
{
  double share = 1.0;               ///< felt stiffness over the coupling's, 0..1
  Vec3 shareSlope_W = Vec3::Zero(); ///< its gradient along the surface [1/u]
  FrictionPlan friction;
  double height_u = 0.0;       ///< of its texture
  Vec3 slope_W = Vec3::Zero(); ///< gradient of the height along the surface
  TextureScale texture;        ///< no finer than two of the face's shortest sides
};

/// Material of feature f at the foot of the ball. Fields are linear over a face and along an edge, there without a
/// slope across the edge. A surface without a field has its own value; a surface without a value of its own has the
/// plan's.
template<SceneView AnyScene>
[[nodiscard]] ContactMaterial materialAt(
  const AnyScene& scene, const ContactPlan& plan, const ActiveFeature& f, const Vec3& foot_W) noexcept;

} // namespace palpate
