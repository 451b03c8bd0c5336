// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/contact/BentSurface.h"
#include "haptics/contact/Motion.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/ExactPredicates.h"
#include "haptics/geometry/Scene.h"
#include "haptics/geometry/SurfaceData.h"

namespace palpate
{

/// A surface where it is at one moment, moved as a whole and bent: the same questions as SurfaceData answers, with
/// corners and normals in W. Every vertex is moved on its own, the same way each time: faces that share one go on
/// sharing it, bit for bit.
class PosedSurface
{
public:
  /// `from`: where its vertices come from, a share of their way ago; null: they stand.
  PosedSurface(
    const SurfaceData& data, const Pose& pose_WS, const VertexStart* from = nullptr, double share = 1.0) noexcept
    : data_(data), shape_(data, from, share), turn_WS_(pose_WS.q.toRotationMatrix()), shift_W_(pose_WS.p)
  {
  }

  [[nodiscard]] Vec3 toWorld(const Vec3& x_S) const noexcept { return this->turn_WS_ * x_S + this->shift_W_; }
  [[nodiscard]] Vec3 toSurface(const Vec3& x_W) const noexcept
  {
    return this->turn_WS_.transpose() * (x_W - this->shift_W_);
  }
  [[nodiscard]] const Vec3& shift_W() const noexcept { return this->shift_W_; }
  [[nodiscard]] Vec3 turned(const Vec3& v_S) const noexcept { return this->turn_WS_ * v_S; }
  /// The same motion as the surface's tree sees it, with room for the rounding of the way there.
  [[nodiscard]] Motion toSurface(const Motion& m) const noexcept;

  [[nodiscard]] const SurfaceData& data() const noexcept { return this->data_; }
  /// What it is in its own frame.
  [[nodiscard]] const BentSurface& shape() const noexcept { return this->shape_; }
  [[nodiscard]] FaceRecord face(std::uint32_t triangle) const noexcept;
  [[nodiscard]] std::array<Vec3, 3> cornersOf(std::uint32_t triangle) const noexcept
  {
    const auto& [a, b, c] = this->shape_.cornersOf(triangle);
    return { this->toWorld(a), this->toWorld(b), this->toWorld(c) };
  }
  [[nodiscard]] Vec3 vertex(std::uint32_t v) const noexcept { return this->toWorld(this->shape_.vertex(v)); }
  /// On which side of a face a point is, exactly, in the surface's own frame.
  [[nodiscard]] int sideOf(std::uint32_t triangle, const Vec3& x_W) const noexcept;
  [[nodiscard]] const std::array<std::uint32_t, 3>& corners(std::uint32_t t) const noexcept
  {
    return this->data_.corners(t);
  }
  [[nodiscard]] bool hasCorner(std::uint32_t t, std::uint32_t v) const noexcept { return this->data_.hasCorner(t, v); }
  [[nodiscard]] std::uint32_t opposite(std::uint32_t t, std::uint32_t i, std::uint32_t j) const noexcept
  {
    return this->data_.opposite(t, i, j);
  }
  [[nodiscard]] std::uint32_t neighbour(std::uint32_t t, std::uint32_t i, std::uint32_t j) const noexcept
  {
    return this->data_.neighbour(t, i, j);
  }
  template<class Visit>
  void forEachAtEdge(std::uint32_t i, std::uint32_t j, Visit visit) const
  {
    this->data_.forEachAtEdge(i, j, visit);
  }
  template<class Visit>
  void forEachAround(std::uint32_t v, Visit visit) const
  {
    this->data_.forEachAround(v, visit);
  }

private:
  const SurfaceData& data_;
  BentSurface shape_;
  Mat3 turn_WS_;
  Vec3 shift_W_;
};

/// A scene at one moment, 0 .. 1 of the way from where its surfaces and their vertices begin to where they end.
class MovingScene
{
public:
  MovingScene(const Scene& scene, double share) noexcept : scene_(scene), share_(share) {}

  [[nodiscard]] const Scene& scene() const noexcept { return this->scene_; }
  [[nodiscard]] double share() const noexcept { return this->share_; }

private:
  const Scene& scene_;
  double share_;
};

/// Two ways to look at a scene: as it stands, which costs nothing, and as it moves.
[[nodiscard]] inline const Scene& sceneOf(const Scene& scene) noexcept
{
  return scene;
}
[[nodiscard]] inline const Scene& sceneOf(const MovingScene& moving) noexcept
{
  return moving.scene();
}
[[nodiscard]] inline const SurfaceData& surfaceOf(const Scene& scene, std::uint32_t i) noexcept
{
  return scene.surfaces()[i].tree->data();
}
[[nodiscard]] inline PosedSurface surfaceOf(const MovingScene& moving, std::uint32_t i) noexcept
{
  const Surface& surface = moving.scene().surfaces()[i];
  return { surface.tree->data(), surface.motion.at(moving.share()), surface.from.get(), moving.share() };
}

[[nodiscard]] inline int sideOf(const PosedSurface& s, std::uint32_t triangle, const Vec3& x_W) noexcept
{
  return s.sideOf(triangle, x_W);
}
[[nodiscard]] inline int sideOf(const SurfaceData& s, std::uint32_t triangle, const Vec3& x_W) noexcept
{
  const auto& [a, b, c] = s.face(triangle).corner_W;
  return orientation(a, b, c, x_W);
}

/// What a tree is asked with: a surface that stands still is asked as it is.
[[nodiscard]] inline const Motion& inTree(const SurfaceData&, const Motion& m) noexcept
{
  return m;
}
[[nodiscard]] inline Motion inTree(const PosedSurface& s, const Motion& m) noexcept
{
  return s.toSurface(m);
}
[[nodiscard]] inline const SurfaceData& dataOf(const SurfaceData& s) noexcept
{
  return s;
}
/// Corners in W: where vertices are on their way they cost less than a whole face.
[[nodiscard]] inline const std::array<Vec3, 3>& cornersIn(const SurfaceData& s, std::uint32_t triangle) noexcept
{
  return s.face(triangle).corner_W;
}
[[nodiscard]] inline std::array<Vec3, 3> cornersIn(const PosedSurface& s, std::uint32_t triangle) noexcept
{
  return s.cornersOf(triangle);
}
[[nodiscard]] inline const SurfaceData& dataOf(const PosedSurface& s) noexcept
{
  return s.data();
}
[[nodiscard]] inline const SurfaceData& dataOf(const BentSurface& s) noexcept
{
  return s.data();
}

/// Calls ask(shape) with the surface in its own frame: one that stands is asked as it is.
template<class Ask>
decltype(auto) askShape(const SurfaceData& s, Ask ask) noexcept
{
  return ask(s);
}
template<class Ask>
decltype(auto) askShape(const PosedSurface& s, Ask ask) noexcept
{
  return s.shape().bends() ? ask(s.shape()) : ask(s.data());
}

/// Calls ask(motion) with what the surface's tree is to be asked for a ball on its way.
template<class View, class Ask>
decltype(auto) askTree(const View& s, const Motion& m, Ask ask) noexcept
{
  const double coat_u = dataOf(s).coat_u;
  return coat_u > 0.0 ? ask(coated(inTree(s, m), coat_u)) : ask(inTree(s, m));
}

} // namespace palpate
