// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/SurfaceResponse.h"

#include <algorithm>

#include "haptics/contact/ContactMaterial.h"

namespace palpate
{
namespace
{

/// All of a texture while a period takes ten ticks, none where it takes five.
double shareOfTexture(const TextureScale& texture, const FeaturePlane& plane, const Vec3& step_W) noexcept
{
  constexpr double fewestTicks = 5.0;
  const double along_u = (step_W - plane.n.dot(step_W) * plane.n).norm();
  return along_u > 0.0 ? std::clamp(texture.period_u / (fewestTicks * along_u) - 1.0, 0.0, 1.0) : 1.0;
}

/// Sums over the planes that hold the ball.
struct Sums
{
  Response response;
  Vec3 normal_W = Vec3::Zero(); ///< of the depths
  double depth_u = 0.0;
  double weighted_u = 0.0; ///< depths times shares

  void add(const ContactMaterial& at, const FeaturePlane& plane, double depth, double texture) noexcept
  {
    const double height_u = at.texture.mean_u + texture * (at.height_u - at.texture.mean_u);
    const double out_u = std::max(0.0, depth + height_u);
    this->response.pull_W +=
      at.share * out_u * (plane.n - texture * at.slope_W) - 0.5 * out_u * out_u * at.shareSlope_W;
    this->response.held_u2 += at.share * out_u * out_u;
    this->normal_W += depth * plane.n;
    this->depth_u += depth;
    this->weighted_u += at.share * depth;
  }
};

} // namespace

template<class SceneView>
Response respond(const SceneView& scene, const ContactPlan& plan, const ContactResult& contact, const Vec3& p_W,
  const Vec3& step_W) noexcept
{
  const Vec3 stretch_W = contact.proxy_W - p_W;
  Sums sums;
  for (int k = 0; k < contact.heldCount; ++k)
  {
    const HeldPlane& held = contact.held[static_cast<std::size_t>(k)];
    const auto& surface = surfaceOf(scene, held.feature.surface);
    const FeaturePlane plane = planeOf(surface, held.feature, contact.proxy_W, plan.radius_u);
    const ContactMaterial at = materialAt(scene, plan, held.feature, plane.foot_W);
    sums.add(at, plane, held.depth_u, shareOfTexture(at.texture, plane, step_W));
  }
  if (sums.depth_u == 0.0)
  {
    return { stretch_W, stretch_W.squaredNorm() };
  }
  const double share = sums.weighted_u / sums.depth_u;
  const Vec3 along_W = stretch_W - sums.normal_W;
  sums.response.pull_W += share * along_W;
  sums.response.held_u2 += share * along_W.squaredNorm();
  return sums.response;
}

template Response respond(const Scene&, const ContactPlan&, const ContactResult&, const Vec3&, const Vec3&) noexcept;
template Response respond(
  const MovingScene&, const ContactPlan&, const ContactResult&, const Vec3&, const Vec3&) noexcept;

} // namespace palpate
