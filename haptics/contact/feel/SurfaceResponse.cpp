// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/feel/SurfaceResponse.h"

#include <algorithm>
#include <array>

#include "haptics/contact/feel/ContactMaterial.h"

namespace palpate
{
namespace
{

/// All of a texture while a period takes ten ticks, none where a period takes five: a texture that is sampled more
/// coarsely only shakes.
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
    const double hollow_u = std::max(0.0, at.texture.largest_u - height_u); // a mean is rounded
    const double out_u = std::max(0.0, depth - hollow_u);
    this->response.pull_W +=
      at.share * out_u * (plane.n - texture * at.slope_W) - 0.5 * out_u * out_u * at.shareSlope_W;
    this->response.held_u2 += at.share * out_u * out_u;
    this->normal_W += depth * plane.n;
    this->depth_u += depth;
    this->weighted_u += at.share * depth;
  }
};

/// The planes that hold the ball, and the position of the hand.
struct Touch
{
  struct Held
  {
    ContactMaterial at;
    FeaturePlane plane;
    double depth_u = 0.0;
  };
  std::array<Held, 3> held{};
  int count = 0;
  Vec3 stretch_W = Vec3::Zero();

  /// The share that the finest of the textures allows.
  [[nodiscard]] double share(const Vec3& step_W) const noexcept
  {
    double least = 1.0;
    for (int k = 0; k < this->count; ++k)
    {
      const Held& one = this->held[static_cast<std::size_t>(k)];
      least = std::min(least, shareOfTexture(one.at.texture, one.plane, step_W));
    }
    return least;
  }

  [[nodiscard]] Response respond(double texture) const noexcept
  {
    Sums sums;
    for (int k = 0; k < this->count; ++k)
    {
      const Held& one = this->held[static_cast<std::size_t>(k)];
      sums.add(one.at, one.plane, one.depth_u, texture);
    }
    if (sums.depth_u == 0.0)
    {
      return { this->stretch_W, this->stretch_W.squaredNorm() };
    }
    const double share = sums.weighted_u / sums.depth_u;
    const Vec3 along_W = this->stretch_W - sums.normal_W;
    sums.response.pull_W += share * along_W;
    sums.response.held_u2 += share * along_W.squaredNorm();
    return sums.response;
  }
};

template<SceneView AnyScene>
Touch touchOf(const AnyScene& scene, const ContactPlan& plan, const ContactResult& contact, const Vec3& p_W) noexcept
{
  Touch touch;
  touch.stretch_W = contact.proxy_W - p_W;
  touch.count = contact.heldCount;
  for (int k = 0; k < contact.heldCount; ++k)
  {
    const ActivePlane& held = contact.held[static_cast<std::size_t>(k)];
    const FeaturePlane plane =
      planeOf(surfaceOf(scene, held.feature.surface), held.feature, contact.proxy_W, plan.radius_u);
    touch.held[static_cast<std::size_t>(k)] = { materialAt(scene, plan, held.feature, plane.foot_W), plane,
      held.depth_u };
  }
  return touch;
}

} // namespace

template<SceneView AnyScene>
Response respond(const AnyScene& scene, const ContactPlan& plan, const ContactResult& contact, const Vec3& p_W,
  const Vec3& step_W, double& texture) noexcept
{
  const Touch touch = touchOf(scene, plan, contact, p_W);
  const double before = texture;
  texture = touch.count > 0 ? touch.share(step_W) : -1.0;
  const Response response = touch.respond(texture);
  if (before < 0.0 || texture == before || touch.count == 0)
  {
    return response;
  }
  const Response asBefore = touch.respond(before);
  if (response.held_u2 <= asBefore.held_u2)
  {
    return response;
  }
  texture = before;
  return asBefore;
}

template Response respond(
  const Scene&, const ContactPlan&, const ContactResult&, const Vec3&, const Vec3&, double&) noexcept;
template Response respond(
  const MovingScene&, const ContactPlan&, const ContactResult&, const Vec3&, const Vec3&, double&) noexcept;

} // namespace palpate
