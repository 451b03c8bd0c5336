// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/contact/view/BentSurface.h"
#include "haptics/contact/view/SweptBall.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// A surface at one moment, moved as a whole and bent. Answers the same questions as SurfaceData, with corners and
/// normals in W. Every vertex is moved on its own, the same way each time, so faces that share a vertex go on sharing
/// it, bit for bit.
class PosedSurface
{
public:
  PosedSurface(const BentSurface& shape, const Pose& pose_WS) noexcept
    : data_(shape.data()), shape_(shape), turn_WS_(pose_WS.q.toRotationMatrix()), shift_W_(pose_WS.p),
      inPlace_(pose_WS.q.coeffs() == Quat::Identity().coeffs() && pose_WS.p == Vec3::Zero())
  {
  }

  [[nodiscard]] Vec3 toWorld(const Vec3& x_S) const noexcept
  {
    return this->inPlace_ ? x_S : Vec3(this->turn_WS_ * x_S + this->shift_W_);
  }
  [[nodiscard]] Vec3 toSurface(const Vec3& x_W) const noexcept
  {
    return this->inPlace_ ? x_W : Vec3(this->turn_WS_.transpose() * (x_W - this->shift_W_));
  }
  [[nodiscard]] const Vec3& shift_W() const noexcept { return this->shift_W_; }
  [[nodiscard]] Vec3 turned(const Vec3& v_S) const noexcept
  {
    return this->inPlace_ ? v_S : Vec3(this->turn_WS_ * v_S);
  }
  /// The same motion as the surface's tree sees it, with room for the rounding of the way there.
  [[nodiscard]] SweptBall toSurface(const SweptBall& m) const noexcept;

  [[nodiscard]] const SurfaceData& data() const noexcept { return this->data_; }
  /// The surface in its own frame.
  [[nodiscard]] const BentSurface& shape() const noexcept { return this->shape_; }
  [[nodiscard]] FaceRecord face(std::uint32_t triangle) const noexcept;
  [[nodiscard]] std::array<Vec3, 3> cornersOf(std::uint32_t triangle) const noexcept
  {
    std::array<Vec3, 3> corners = this->shape_.cornersOf(triangle);
    this->place(corners);
    return corners;
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
  void place(std::array<Vec3, 3>& corners) const noexcept
  {
    if (!this->inPlace_)
    {
      for (Vec3& corner : corners)
      {
        corner = this->toWorld(corner);
      }
    }
  }

  const SurfaceData& data_;
  BentSurface shape_;
  Mat3 turn_WS_;
  Vec3 shift_W_;
  bool inPlace_; ///< its frame is W, as that of most surfaces that bend
};

} // namespace palpate
