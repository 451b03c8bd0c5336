// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "haptics/core/Types.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/VertexStart.h"

namespace palpate
{

/// A surface in its own frame at one moment of the way that its vertices make. Answers the same questions as
/// SurfaceData. Only the triangles that are asked for are computed; boxes and discs of the tree hold all of the way.
/// Every vertex is moved on its own, the same way each time: faces that share one go on sharing it, bit for bit.
class BentSurface
{
public:
  /// `from`: null for a surface that stands. `share`: 0..1 of the way.
  BentSurface(const SurfaceData& data, const VertexStart* from, double share) noexcept
    : data_(data), from_(share < 1.0 ? from : nullptr), share_(share)
  {
  }

  /// False where the vertices are those of the tree.
  [[nodiscard]] bool bends() const noexcept { return this->from_ != nullptr; }
  [[nodiscard]] const SurfaceData& data() const noexcept { return this->data_; }
  [[nodiscard]] Vec3 vertex(std::uint32_t v) const noexcept
  {
    return this->bends() ? alongWay(this->from_->vertices_W[v], this->data_.vertex(v), this->share_)
                         : this->data_.vertex(v);
  }
  [[nodiscard]] std::array<Vec3, 3> cornersOf(std::uint32_t triangle) const noexcept
  {
    const auto& t = this->data_.corners(triangle);
    return { this->vertex(t[0]), this->vertex(t[1]), this->vertex(t[2]) };
  }
  /// A face that has no area at this moment keeps the normal it ends with.
  [[nodiscard]] FaceRecord face(std::uint32_t triangle) const noexcept;
  [[nodiscard]] const std::array<std::uint32_t, 3>& corners(std::uint32_t t) const noexcept
  {
    return this->data_.corners(t);
  }

private:
  const SurfaceData& data_;
  const VertexStart* from_;
  double share_;
};

/// False for a triangle without area at this moment of its way: its sides are then those of other triangles.
[[nodiscard]] bool hasArea(const BentSurface& s, const FaceRecord& face) noexcept;
[[nodiscard]] inline bool hasArea(const SurfaceData&, const FaceRecord&) noexcept
{
  return true;
}

} // namespace palpate
