// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "haptics/contact/view/SceneView.h"
#include "haptics/contact/view/SweptBall.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// All faces within reach of a point, gathered once: the later sweeps of a tick look only at these.
/// A neighbourhood never changes a result, only the cost. Servo thread; fixed memory, no allocation.
class Neighbourhood
{
public:
  struct Face
  {
    std::uint32_t surface;
    std::uint32_t triangle;
  };

  /// True if every face that the motion can touch is in the list.
  [[nodiscard]] bool covers(const SweptBall& m) const noexcept;
  /// Gathers the faces around the motion, with room for the motions that follow. False if they do not fit.
  template<SceneView AnyScene>
  [[nodiscard]] bool gather(
    const AnyScene& scene, const SweptBall& m, std::uint32_t budget, std::uint32_t& nodes) noexcept;

  [[nodiscard]] int count() const noexcept { return this->count_; }
  [[nodiscard]] const Face& face(int i) const noexcept { return this->faces_[i]; }
  /// Discs of faces 4 quad .. 4 quad + 3, relative to centre_W().
  [[nodiscard]] const DiscQuad& discs(int quad) const noexcept { return this->discs_[quad]; }
  [[nodiscard]] const Vec3& centre_W() const noexcept { return this->centre_W_; }
  /// 1 u in the unit of the discs.
  [[nodiscard]] double perUnit() const noexcept { return this->perUnit_; }
  /// No coordinate of a disc relative to centre_W() is larger than this, in that unit.
  [[nodiscard]] double extent() const noexcept { return this->extent_; }

private:
  static constexpr int capacity = 512; ///< faces, 18 kB with their discs; a tick among more goes without a list

  template<class View>
  [[nodiscard]] bool gatherSurface(const View& view, std::uint32_t surface, const SweptBall& still,
    std::uint32_t budget, std::uint32_t& nodes) noexcept;
  template<class View, class Shape>
  [[nodiscard]] bool gatherLeaves(const View& view, const Shape& shape, std::uint32_t surface,
    const SweptBall& inSurface, std::uint32_t budget, std::uint32_t& nodes) noexcept;
  template<class View>
  void add(const View& view, std::uint32_t surface, std::uint32_t leaf, std::uint32_t lane) noexcept;

  Vec3 centre_W_ = Vec3::Zero();
  double reach_u_ = -1.0; ///< negative: nothing gathered
  double perUnit_ = 1.0;
  double extent_ = 0.0;
  bool crowded_ = false; ///< gathering did not fit once: not tried again
  int count_ = 0;
  std::array<Face, capacity> faces_;
  std::array<DiscQuad, capacity / 4> discs_;
};

} // namespace palpate
