// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// A box aligned with its content, for the traversal: all points centre + axes * h with |h_i| <= half_i. The axes
/// are unit and orthogonal to a float's rounding only; the half sides allow for that.
struct OrientedBox
{
  Vec3 centre = Vec3::Zero();
  Mat3 axes = Mat3::Identity();
  Vec3 half = Vec3::Zero();
};

/// Rounded outward to floats: 40 bytes.
class StoredBox
{
public:
  StoredBox() = default;
  /// Axes as columns, a rotation. `points` are the corners of its content.
  StoredBox(const Mat3& axes, std::span<const Vec3> points);

  [[nodiscard]] Vec3 centre() const noexcept { return { this->centre_[0], this->centre_[1], this->centre_[2] }; }
  [[nodiscard]] Vec3 half() const noexcept { return { this->half_[0], this->half_[1], this->half_[2] }; }
  /// Unit to a float's rounding.
  [[nodiscard]] Quat turn() const noexcept
  {
    return { this->turn_[3], this->turn_[0], this->turn_[1], this->turn_[2] };
  }
  [[nodiscard]] OrientedBox box() const noexcept;

private:
  std::array<float, 3> centre_{};
  std::array<float, 4> turn_{ 0.0f, 0.0f, 0.0f, 1.0f };
  std::array<float, 3> half_{};
};

/// A triangle's edges and corners that can never be the first contact: an edge between coplanar faces, a vertex
/// inside of such faces or along a straight edge. The flags only save work.
struct FlatFlags
{
  std::uint8_t bits = 0;

  [[nodiscard]] bool edge(int k) const noexcept { return (this->bits >> k & 1) != 0; }         ///< from corner k on
  [[nodiscard]] bool corner(int k) const noexcept { return (this->bits >> (3 + k) & 1) != 0; } ///< corner k
  [[nodiscard]] bool all() const noexcept { return this->bits == 63; }
};

/// Triangles in the order of a tree of oriented boxes: the rigid shape of a tool, in its body frame B, or of the scene
/// it touches, in W. Immutable.
class BoxedMesh
{
public:
  struct Node
  {
    StoredBox box;
    std::uint32_t second = 0; ///< inner: index of the second child, the first comes next. Leaf: its first triangle
    std::uint32_t count = 0;  ///< triangles of a leaf; 0: inner

    [[nodiscard]] bool leaf() const noexcept { return this->count > 0; }
  };

  /// `clean`: a result of cleanMesh(). Bends below `flat_u` count as flat.
  BoxedMesh(TriangleMesh clean, double flat_u);

  [[nodiscard]] const TriangleMesh& mesh() const noexcept { return this->mesh_; }
  [[nodiscard]] const std::vector<Node>& nodes() const noexcept { return this->nodes_; }
  [[nodiscard]] FlatFlags flat(std::uint32_t triangle) const noexcept { return this->flat_[triangle]; }
  [[nodiscard]] const Vec3& corner(std::uint32_t triangle, int k) const noexcept
  {
    return this->mesh_.vertices_W[this->mesh_.triangles[triangle][k]];
  }
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t triangle) const noexcept
  {
    return { this->corner(triangle, 0), this->corner(triangle, 1), this->corner(triangle, 2) };
  }

private:
  TriangleMesh mesh_;
  std::vector<Node> nodes_;
  std::vector<FlatFlags> flat_;
};

/// The unit normal of three corners, its side given by their order; also for slivers, whose edges are scaled first.
[[nodiscard]] Vec3 unitNormal(const std::array<Vec3, 3>& corners) noexcept;

} // namespace palpate
