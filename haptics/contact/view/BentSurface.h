// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "haptics/contact/view/FaceCache.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/VertexStart.h"

namespace palpate
{

/// A surface in its own frame at one moment of the way that its vertices make. Answers the same questions as
/// SurfaceData. Only requested data are computed, triangles and boxes of the tree alike.
/// Every vertex is moved on its own, the same way each time: faces that share one go on sharing it, bit for bit.
class BentSurface
{
public:
  /// `from`: null for a surface that stands. `share`: 0..1 of the way. `cache`: keeps its faces as those of surface
  /// `number` at this moment.
  BentSurface(const SurfaceData& data, const VertexStart* from, double share, FaceCache* cache = nullptr,
    std::uint32_t number = 0) noexcept
    : data_(data), from_(share < 1.0 ? from : nullptr), share_(share), cache_(cache), number_(number)
  {
  }

  /// False where the vertices are those of the tree.
  [[nodiscard]] bool bends() const noexcept { return this->from_ != nullptr; }
  /// True if a face that was asked for once costs little when it is asked for again.
  [[nodiscard]] bool keepsFaces() const noexcept { return this->cache_ != nullptr; }
  [[nodiscard]] const SurfaceData& data() const noexcept { return this->data_; }
  [[nodiscard]] Vec3 vertex(std::uint32_t v) const noexcept
  {
    return this->bends() ? alongWay(this->from_->vertices_W[v], this->data_.vertex(v), this->share_)
                         : this->data_.vertex(v);
  }
  [[nodiscard]] std::array<Vec3, 3> cornersOf(std::uint32_t triangle) const noexcept
  {
    const FaceRecord* const kept =
      this->bends() && this->keepsFaces() ? this->cache_->find(this->number_, triangle) : nullptr;
    return kept != nullptr ? kept->corner_W : this->cornersOnTheirWay(triangle);
  }
  /// A face that has no area at this moment keeps the normal it ends with.
  [[nodiscard]] FaceRecord face(std::uint32_t triangle) const noexcept;
  [[nodiscard]] const std::array<std::uint32_t, 3>& corners(std::uint32_t t) const noexcept
  {
    return this->data_.corners(t);
  }
  /// How much of the tree's own vertices, and of each of its other places, is in where the vertices are now.
  [[nodiscard]] std::array<double, 3> shares() const noexcept;

private:
  [[nodiscard]] FaceRecord faceOnItsWay(std::uint32_t triangle) const noexcept;
  [[nodiscard]] std::array<Vec3, 3> cornersOnTheirWay(std::uint32_t triangle) const noexcept
  {
    const auto& t = this->data_.corners(triangle);
    return { this->vertex(t[0]), this->vertex(t[1]), this->vertex(t[2]) };
  }

  const SurfaceData& data_;
  const VertexStart* from_;
  double share_;
  FaceCache* cache_;
  std::uint32_t number_;
};

/// The tree of a surface at that moment: a vertex is a mean of its places, so it is within the same mean of boxes that
/// hold it there.
class BentNodes
{
public:
  explicit BentNodes(const BentSurface& shape) noexcept;
  [[nodiscard]] bool empty() const noexcept { return this->data_.nodes.empty(); }
  [[nodiscard]] TreeNode operator[](std::uint32_t index) const noexcept;
  /// Around all of the surface.
  [[nodiscard]] Box bounds() const noexcept;

private:
  const SurfaceData& data_;
  std::array<double, 3> shares_;
  double rounding_u_; ///< of a vertex on its way and of a mean of boxes, together
};

[[nodiscard]] inline const std::vector<TreeNode>& nodesOf(const SurfaceData& s) noexcept
{
  return s.nodes;
}
[[nodiscard]] inline Box boundsOf(const SurfaceData& s) noexcept
{
  return { s.low_W, s.high_W };
}
[[nodiscard]] inline const DiscQuad& discsOf(const SurfaceData& s, std::size_t quad) noexcept
{
  return s.discs[quad];
}
[[nodiscard]] inline BentNodes nodesOf(const BentSurface& s) noexcept
{
  return BentNodes(s);
}
[[nodiscard]] inline Box boundsOf(const BentSurface& s) noexcept
{
  return BentNodes(s).bounds();
}
/// Balls around four faces at that moment: discs without a normal.
[[nodiscard]] DiscQuad discsOf(const BentSurface& s, std::size_t quad) noexcept;

/// False for a triangle without area at this moment of its way: its sides are then those of other triangles.
[[nodiscard]] bool hasArea(const BentSurface& s, const FaceRecord& face) noexcept;
[[nodiscard]] inline bool hasArea(const SurfaceData&, const FaceRecord&) noexcept
{
  return true;
}

} // namespace palpate
