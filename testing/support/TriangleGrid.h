// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// The triangles of a mesh by cell: the judges look at near ones instead of all of them. Comparisons, monotone
/// roundings and slack for the roundings: a near triangle is never missed.
class TriangleGrid
{
public:
  explicit TriangleGrid(const TriangleMesh& mesh);

  [[nodiscard]] const TriangleMesh& mesh() const noexcept { return this->mesh_; }
  /// At least all triangles that come within `margin_u` of the segment, each once.
  [[nodiscard]] std::vector<std::uint32_t> near(const Vec3& from_W, const Vec3& to_W, double margin_u) const;

private:
  /// A part of a segment, in shares of it.
  struct Span
  {
    double from = 0.0, to = 1.0;
  };
  [[nodiscard]] int cellOf(double value, int axis) const noexcept;
  [[nodiscard]] Span inside(const Vec3& from_W, const Vec3& to_W, double room_u) const noexcept;
  template<class Visit>
  void forEachCell(const Vec3& low_W, const Vec3& high_W, Visit visit) const;
  template<class Visit>
  void forEachTriangle(Visit visit) const;

  TriangleMesh mesh_;
  Vec3 low_W_, high_W_;
  double cell_u_ = 1.0;
  std::array<int, 3> sides_{};
  std::vector<std::uint32_t> begins_; ///< of a cell in triangles_; one more than there are cells
  std::vector<std::uint32_t> triangles_;
};

} // namespace palpate::test
