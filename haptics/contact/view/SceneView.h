// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "haptics/contact/view/PosedSurface.h"
#include "haptics/contact/view/SweptBall.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// A scene at one moment, 0 .. 1 of the way from where its surfaces and their vertices begin to where they end.
class MovingScene
{
public:
  /// `cache`: new, or one that was used for this moment alone; it outlives the surfaces.
  MovingScene(const Scene& scene, double share, FaceCache* cache = nullptr) noexcept
    : scene_(scene), share_(share), cache_(cache)
  {
  }

  [[nodiscard]] const Scene& scene() const noexcept { return this->scene_; }
  [[nodiscard]] double share() const noexcept { return this->share_; }
  [[nodiscard]] FaceCache* cache() const noexcept { return this->cache_; }

private:
  const Scene& scene_;
  double share_;
  FaceCache* cache_;
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
  const BentSurface shape(surface.tree->data(), surface.from.get(), moving.share(), moving.cache(), i);
  return { shape, surface.motion.at(moving.share()) };
}

/// The surfaces of listed faces, of which one after the other is mostly of the same: one that moves is placed once.
template<class AnyScene>
class OneSurface
{
public:
  [[nodiscard]] const auto& of(const AnyScene& scene, std::uint32_t i) noexcept
  {
    return this->of(scene, i, [](const auto&) noexcept {});
  }
  /// Calls onPlaced(surface) where another one is placed.
  template<class OnPlaced>
  [[nodiscard]] const auto& of(const AnyScene& scene, std::uint32_t i, OnPlaced onPlaced) noexcept
  {
    if constexpr (std::is_same_v<AnyScene, MovingScene>)
    {
      if (i != this->number_ || !this->placed_)
      {
        this->placed_.emplace(surfaceOf(scene, i));
        this->number_ = i;
        onPlaced(*this->placed_);
      }
      return *this->placed_;
    }
    else
    {
      return surfaceOf(scene, i);
    }
  }

private:
  std::optional<PosedSurface> placed_;
  std::uint32_t number_ = 0;
};

/// How a tick looks at a scene: as the scene stands (Scene), or at a moment of its motion (MovingScene). Ask sceneOf()
/// for the whole and surfaceOf() for one surface; the answers of a surface that stands cost nothing.
template<class T>
concept SceneView = requires(const T& scene, std::uint32_t i)
{
  {
    sceneOf(scene)
    } -> std::same_as<const Scene&>;
  surfaceOf(scene, i);
};

[[nodiscard]] inline int sideOf(const PosedSurface& s, std::uint32_t triangle, const Vec3& x_W) noexcept
{
  return s.sideOf(triangle, x_W);
}
[[nodiscard]] inline int sideOf(const SurfaceData& s, std::uint32_t triangle, const Vec3& x_W) noexcept
{
  const auto& [a, b, c] = s.face(triangle).corner_W;
  return orientation(a, b, c, x_W);
}

/// The argument of a query: a surface at rest is queried directly.
[[nodiscard]] inline const SweptBall& inTree(const SurfaceData&, const SweptBall& m) noexcept
{
  return m;
}
[[nodiscard]] inline SweptBall inTree(const PosedSurface& s, const SweptBall& m) noexcept
{
  return s.toSurface(m);
}
[[nodiscard]] inline const SurfaceData& dataOf(const SurfaceData& s) noexcept
{
  return s;
}
/// Corners in W: where vertices are on their way they cost less than a whole face.
[[nodiscard]] inline std::array<Vec3, 3> cornersIn(const SurfaceData& s, std::uint32_t triangle) noexcept
{
  return s.cornersOf(triangle);
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

/// Calls ask(motion) with the argument of the surface's tree for a moving ball.
template<class View, class Ask>
decltype(auto) askTree(const View& s, const SweptBall& m, Ask ask) noexcept
{
  const double coat_u = dataOf(s).coat_u;
  return coat_u > 0.0 ? ask(coated(inTree(s, m), coat_u)) : ask(inTree(s, m));
}

} // namespace palpate
