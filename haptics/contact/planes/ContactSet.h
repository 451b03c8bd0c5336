// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <type_traits>

#include "haptics/contact/planes/FeatureGeometry.h"
#include "haptics/contact/planes/Projection.h"
#include "haptics/contact/view/GodObjectState.h"
#include "haptics/contact/view/Resolution.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// The touched features of one tick, on top of GodObjectState: add, drop, re-linearise, solve.
/// Servo thread; no allocation. AnyScene: Scene or MovingScene, both instantiated in ContactSet.cpp.
template<SceneView AnyScene>
class ContactSet
{
public:
  ContactSet(const AnyScene& scene, double radius_u, GodObjectState& state) noexcept;

  [[nodiscard]] int count() const noexcept { return this->state_.count; }
  [[nodiscard]] ActiveFeature& feature(int i) noexcept { return this->state_.features[i]; }
  [[nodiscard]] std::span<const ActiveFeature> features() const noexcept
  {
    return { this->state_.features.data(), static_cast<std::size_t>(this->state_.count) };
  }
  [[nodiscard]] decltype(auto) surface(const ActiveFeature& f) const noexcept
  {
    return surfaceOf(this->scene_, f.surface);
  }
  /// Radius with which the ball rolls round f: its own and the coat of the touched feature [u].
  [[nodiscard]] double radius(const ActiveFeature& f) const noexcept
  {
    return this->radius_u_ + sceneOf(this->scene_).surfaces()[f.surface].tree->data().coat_u;
  }
  [[nodiscard]] FeaturePlane plane(const ActiveFeature& f) const noexcept
  {
    return planeOf(this->surface(f), f, this->state_.x_W, this->radius_u_);
  }
  /// True while f goes on holding the ball where it is.
  [[nodiscard]] bool supported(const ActiveFeature& f) const noexcept;

  [[nodiscard]] const Resolution& resolution() const noexcept { return this->resolution_; }
  void include(const Vec3& v_W) noexcept { this->resolution_.include(v_W); }
  /// The coordinates that a plane of f is computed from.
  void include(const ActiveFeature& f) noexcept;

  /// Adds f unless it is there; returns its index.
  int add(const ActiveFeature& f) noexcept;
  void remove(int i) noexcept;
  [[nodiscard]] bool has(const ActiveFeature& f) const noexcept { return this->isAmong(f, this->count()); }
  /// After a move: normalises, drops planes that no longer support the ball (never `keep`), merges equal planes.
  void relinearise(const ActiveFeature* keep = nullptr) noexcept;
  /// Walks every touched face along a move that has been made from x_W - moved.
  void advanceFaces(const Vec3& from_W, const Vec3& moved) noexcept;

  /// The row that keeps the ball `lift` above feature i's plane.
  [[nodiscard]] PlaneRow row(int i, double lift) const noexcept;
  /// Nearest displacement to q under all touched planes.
  [[nodiscard]] ProjectionResult solve(const Vec3& q, double lift) const noexcept;
  /// How far above a plane the ball is kept: a point must never lie on a triangle, a ball touches.
  [[nodiscard]] double lift() const noexcept
  {
    // One del where surfaces stand. Where they move, the way from their frame to W and back is rounded too, product by
    // product.
    constexpr double units = std::is_same_v<AnyScene, MovingScene> ? 6.0 : 1.0;
    return this->radius_u_ > 0.0 ? 0.0 : this->raised_ * units * this->resolution_.del();
  }
  /// Keeps a point higher for the rest of the tick. The normal of a sliver is known so badly that the computed plane of
  /// the sliver cuts through the sliver itself. Planes that hold the point at the new height stay active. False: the
  /// point is as high as it may be.
  bool raise() noexcept;

private:
  /// How far above its plane a face still holds a point [u].
  [[nodiscard]] double holdsWithin(const ActiveFeature& f) const noexcept;
  /// True if f is one of the first so many features.
  [[nodiscard]] bool isAmong(const ActiveFeature& f, int first) const noexcept;

  const AnyScene& scene_;
  double radius_u_;
  GodObjectState& state_;
  Resolution resolution_;
  double raised_ = 1.0; ///< multiple of the smallest lift, doubled by raise()
};

} // namespace palpate
