// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/SurfaceResponse.h"

#include <algorithm>

#include "haptics/contact/ContactMaterial.h"

namespace palpate
{
namespace
{

/// Ticks a period of a texture must last to be felt as one: L / v > 5 T with a period of two grains.
double shareOfTexture(double grain_u, double step_u) noexcept
{
  constexpr double ticksPerPeriod = 5.0;
  return step_u > 0.0 ? std::min(1.0, 2.0 * grain_u / (ticksPerPeriod * step_u)) : 1.0;
}

} // namespace

template<class SceneView>
Vec3 respond(const SceneView& scene, const ContactPlan& plan, const ContactResult& contact, const Vec3& p_W,
  double step_u) noexcept
{
  const Vec3 stretch_W = contact.proxy_W - p_W;
  Vec3 normal_W = Vec3::Zero(), pull_W = Vec3::Zero();
  double depth = 0.0, weighted = 0.0;
  for (int k = 0; k < contact.heldCount; ++k)
  {
    const HeldPlane& held = contact.held[static_cast<std::size_t>(k)];
    const auto& surface = surfaceOf(scene, held.feature.surface);
    const FeaturePlane plane = planeOf(surface, held.feature, contact.proxy_W, plan.radius_u);
    const ContactMaterial at = materialAt(scene, plan, held.feature, plane.foot_W);
    const double texture = shareOfTexture(at.grain_u, step_u);
    const double out_u = std::max(0.0, held.depth_u + texture * at.height_u);
    normal_W += held.depth_u * plane.n;
    pull_W += at.stiffnessFactor * out_u * (plane.n - texture * at.slope_W);
    depth += held.depth_u;
    weighted += at.stiffnessFactor * held.depth_u;
  }
  return depth > 0.0 ? Vec3(pull_W + weighted / depth * (stretch_W - normal_W)) : stretch_W;
}

template Vec3 respond(const Scene&, const ContactPlan&, const ContactResult&, const Vec3&, double) noexcept;
template Vec3 respond(const MovingScene&, const ContactPlan&, const ContactResult&, const Vec3&, double) noexcept;

} // namespace palpate
