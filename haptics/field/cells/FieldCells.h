// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "haptics/field/cells/CellMap.h"
#include "haptics/field/cells/GridPlace.h"

namespace palpate
{

/// Corners of a cell, indices of points in the order of TrilinearCell; a wedge, pyramid or tetrahedron names some
/// twice.
using CellCorners = std::array<std::uint32_t, 8>;

/// Input of cells: points, a value at each, and the corners of each cell.
struct CellParts
{
  std::vector<Vec3> points_W;
  std::vector<float> values; ///< of the scalar, less the offset
  double offset = 0.0;
  std::vector<CellCorners> corners;
  Vec3 centre_W = Vec3::Zero(); ///< they are those around this place [u]
  double reach_u =
    std::numeric_limits<double>::infinity(); ///< all that are as near, along each axis; infinite: all of the data's
};

/// The data's own cells around a hand with the values of its scalar, trilinear in each as its shape functions have it:
/// whatever the length of cells is across a boundary layer and along it, a surface is where the data has it. Immutable.
/// A place is the index of a cell, first, and where in it.
class FieldCells
{
public:
  static constexpr std::uint32_t none = 0xffffffffU;
  /// Largest memory of one cell with its share of points [bytes].
  static constexpr std::size_t bytesACell = 100;

  /// In the order of a tree, without cells that have a corner with no value, and points that no cell has.
  [[nodiscard]] static std::shared_ptr<const FieldCells> make(CellParts parts);
  /// Of parts that are in this order. Corners are known to be points.
  explicit FieldCells(CellParts ordered);

  [[nodiscard]] const CellParts& parts() const noexcept { return this->parts_; }
  [[nodiscard]] std::uint64_t contentHash() const noexcept { return this->contentHash_; }
  [[nodiscard]] std::size_t bytes() const noexcept;
  [[nodiscard]] bool holds(const GridIndex& cell) const noexcept
  {
    return static_cast<std::size_t>(cell[0]) < this->parts_.corners.size() && cell[1] == 0 && cell[2] == 0;
  }
  /// Depth of a point inside the loaded cells [u].
  [[nodiscard]] double roomAt_u(const Vec3& p_W) const noexcept
  {
    return this->parts_.reach_u - (p_W - this->parts_.centre_W).cwiseAbs().maxCoeff();
  }

  [[nodiscard]] CellMap map(const GridIndex& cell) const noexcept;
  /// The corners of a cell, less `level`, times `sign`.
  [[nodiscard]] TrilinearCell cell(const GridIndex& at, double level = 0.0, double sign = 1.0) const noexcept;
  [[nodiscard]] Vec3 toWorld(const GridPlace& place) const noexcept { return this->map(place.cell).at(place.t); }
  /// The cell that a place in W is in, another than `other`; none outside.
  [[nodiscard]] std::optional<GridPlace> locate(const Vec3& p_W, int other = -1) const noexcept;
  /// The same place on a face of a cell, as the cell beyond that face has it: face 2 k where t[k] is 0, then where t[k]
  /// is 1. None: no cell shares that face.
  [[nodiscard]] std::optional<GridPlace> across(const GridPlace& place, int face) const noexcept;

private:
  using Faces = std::array<std::uint32_t, 6>; ///< per face six times a cell and the face of it that is the same
  void joinFaces();
  void boundTree();

  CellParts parts_;
  std::uint64_t contentHash_ = 0;
  std::vector<Faces> beyond_;
  std::vector<Eigen::AlignedBox3d> boxes_; ///< of the nodes of a tree whose halves are halves of the cells
};

} // namespace palpate
