// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/core/PoseMath.h"
#include "haptics/field/cells/FieldCells.h"
#include "haptics/field/cells/GridPlace.h"
#include "haptics/field/cells/TrilinearCell.h"

namespace palpate
{

/// Where the points of a uniform grid are.
struct FieldBlockGrid
{
  GridIndex size{};              ///< points along each axis, at least 2
  Vec3 spacing_u = Vec3::Ones(); ///< between neighbours [u], larger than 0
  Pose pose_W = {};              ///< of the first point; its axes are those of the grid

  [[nodiscard]] std::size_t points() const noexcept
  {
    return static_cast<std::size_t>(this->size[0]) * static_cast<std::size_t>(this->size[1]) *
           static_cast<std::size_t>(this->size[2]);
  }
  [[nodiscard]] Vec3 toIndex(const Vec3& p_W) const noexcept
  {
    return into(this->pose_W, p_W).cwiseQuotient(this->spacing_u);
  }
  [[nodiscard]] Vec3 toWorld(const Vec3& index) const noexcept
  {
    return this->pose_W * index.cwiseProduct(this->spacing_u);
  }
  /// How far a place is inside of all faces of the grid [u]; negative: outside of one.
  [[nodiscard]] double roomAt_u(const Vec3& p_W) const noexcept
  {
    const Vec3 index = this->toIndex(p_W);
    const Vec3 last(this->size[0] - 1, this->size[1] - 1, this->size[2] - 1);
    return index.cwiseMin(last - index).cwiseProduct(this->spacing_u).minCoeff();
  }
  /// A covector of index coordinates, such as a gradient, in W [1/u].
  [[nodiscard]] Vec3 gradientToWorld(const Vec3& gradient) const noexcept
  {
    return this->pose_W.q * gradient.cwiseQuotient(this->spacing_u);
  }
};

/// The use of an array of a block.
enum class FieldBlockRole : std::uint8_t
{
  Scalar,     ///< isosurface, detent, extrema
  Vector,     ///< followed, pushed by; three components in the axes of W
  Resistance, ///< how strongly the hand is dragged; not negative
  Other,      ///< compared with the scalar
  Axis,       ///< followed where there is no vector: three components in the axes of W, whose sign means nothing
};

/// A straight piece of a line, from end to end, in W.
using FieldBlockLine = std::array<Vec3, 2>;
[[nodiscard]] Vec3 nearestOn(const FieldBlockLine& line_W, const Vec3& p_W) noexcept;

/// Values at the points of a grid, x fastest, components together, less an offset: so single precision resolves small
/// differences of large numbers. NaN: there is no value.
struct FieldBlockArray
{
  FieldBlockRole role = FieldBlockRole::Scalar;
  std::string name; ///< for people
  std::vector<float> values;
  double offset = 0.0; ///< finite; of vectors and axes 0
};

[[nodiscard]] constexpr int componentsOf(FieldBlockRole role) noexcept
{
  return role == FieldBlockRole::Vector || role == FieldBlockRole::Axis ? 3 : 1;
}

/// One component of an array on the grid of its block, which must outlive it.
class FieldBlockComponent
{
public:
  FieldBlockComponent() = default;
  FieldBlockComponent(const GridIndex& size, const float* values, int stride, double offset = 0.0) noexcept
    : size_(size), values_(values), offset_(offset), stride_(stride),
      row_(stride * static_cast<std::ptrdiff_t>(size[0])), layer_(row_ * size[1])
  {
  }

  [[nodiscard]] bool exists() const noexcept { return this->values_ != nullptr; }
  [[nodiscard]] const GridIndex& size() const noexcept { return this->size_; }
  [[nodiscard]] bool holds(const GridIndex& cell) const noexcept
  {
    const auto in = [](int at, int points) { return static_cast<unsigned>(at) < static_cast<unsigned>(points - 1); };
    return in(cell[0], this->size_[0]) && in(cell[1], this->size_[1]) && in(cell[2], this->size_[2]);
  }
  [[nodiscard]] double at(const GridIndex& point) const noexcept
  {
    return this->offset_ + this->values_[point[2] * this->layer_ + point[1] * this->row_ + point[0] * this->stride_];
  }
  /// The corners of a cell that the grid holds, less `level`, times `sign`.
  [[nodiscard]] TrilinearCell cell(const GridIndex& at, double level = 0.0, double sign = 1.0) const noexcept
  {
    const float* const v = this->values_ + at[2] * this->layer_ + at[1] * this->row_ + at[0] * this->stride_;
    const float *const y = v + this->row_, *const z = v + this->layer_, *const yz = z + this->row_;
    const auto s = this->stride_;
    const double less = level - this->offset_;
    return { { sign * (v[0] - less), sign * (v[s] - less), sign * (y[0] - less), sign * (y[s] - less),
      sign * (z[0] - less), sign * (z[s] - less), sign * (yz[0] - less), sign * (yz[s] - less) } };
  }
  /// Where the cell of a place is, moved into the grid from its far faces; none outside.
  [[nodiscard]] std::optional<GridPlace> within(GridPlace place) const noexcept;

private:
  GridIndex size_{};
  const float* values_ = nullptr;
  double offset_ = 0.0;
  std::ptrdiff_t stride_ = 1, row_ = 0, layer_ = 0;
};

/// A value, and how it changes, in W [1/u].
struct FieldSample
{
  double value = 0.0;
  Vec3 gradient_W = Vec3::Zero();
};

/// Numbers in space around a hand: arrays on one uniform grid. Immutable once made: the servo reads it, a worker frees
/// it. Between points values are trilinear. A cell with a corner that has no value has none.
class FieldBlock
{
public:
  /// All blocks together are to stay below 32 MB; an owner may hold the one felt, the one before and the one being
  /// made.
  static constexpr std::size_t mostBytes = std::size_t{ 9 } << 20;

  /// Empty, or one sentence why these are no block.
  [[nodiscard]] static std::string refuse(const FieldBlockGrid& grid, const std::vector<FieldBlockArray>& arrays,
    std::size_t mostBytes = FieldBlock::mostBytes);
  static constexpr std::size_t mostPlaces = 256; ///< that a hand snaps to: a tick looks at all of them
  /// Assumptions that refuse() does not check. Infinities become NaN: there is no value. `places_W`, `lines_W`: places
  /// and lines of the detents, the first mostPlaces of each. `finer`: the same arrays at points that are nearer to each
  /// other, in a part of this block, without a finer block of its own. `cells`: the data's own, with the scalar, where
  /// the data have one.
  FieldBlock(std::uint64_t revision, const FieldBlockGrid& grid, std::vector<FieldBlockArray> arrays,
    std::vector<Vec3> places_W = {}, std::vector<FieldBlockLine> lines_W = {},
    std::shared_ptr<const FieldBlock> finer = nullptr, std::shared_ptr<const FieldCells> cells = nullptr);

  [[nodiscard]] std::uint64_t revision() const noexcept { return this->revision_; }
  [[nodiscard]] const FieldBlockGrid& grid() const noexcept { return this->grid_; }
  [[nodiscard]] const std::vector<FieldBlockArray>& arrays() const noexcept { return this->arrays_; }
  [[nodiscard]] const std::vector<Vec3>& places_W() const noexcept { return this->places_W_; }
  [[nodiscard]] const std::vector<FieldBlockLine>& lines_W() const noexcept { return this->lines_W_; }
  /// Null: there is none.
  [[nodiscard]] const std::shared_ptr<const FieldBlock>& finer() const noexcept { return this->finer_; }
  /// Null: the scalar is known at the points of the grid alone.
  [[nodiscard]] const std::shared_ptr<const FieldCells>& cells() const noexcept { return this->cells_; }
  /// The finer one where that reaches to a place, else this.
  [[nodiscard]] const FieldBlock& finestAt(const Vec3& p_W) const noexcept;
  /// Hash of grid, roles, values, places, lines, of the finer one and of the cells: names a block in a recording.
  [[nodiscard]] std::uint64_t contentHash() const noexcept { return this->contentHash_; }
  /// This or the finer one, whichever has that hash; null: neither.
  [[nodiscard]] const FieldBlock* called(std::uint64_t contentHash) const noexcept;
  [[nodiscard]] std::size_t bytes() const noexcept;

  /// One component of the array with that role; exists() is false without such an array.
  [[nodiscard]] FieldBlockComponent component(FieldBlockRole role, int component = 0) const noexcept;
  /// The scalar at a place in W as a surface of it is felt: that of the data's own cells where they are there. None
  /// outside.
  [[nodiscard]] std::optional<double> scalarFelt(const Vec3& p_W) const noexcept;
  /// The trilinear value at a place in W; none outside and where a corner has none.
  [[nodiscard]] std::optional<FieldSample> sample(FieldBlockRole role, const Vec3& p_W) const noexcept;
  /// The snap target nearest to a hand at p_W; none within that reach.
  [[nodiscard]] std::optional<Vec3> nearestPlace_W(const Vec3& p_W, double reach_u) const noexcept;
  /// The trilinear vector at a place in W, in W.
  [[nodiscard]] std::optional<Vec3> vector(const Vec3& p_W) const noexcept;
  /// The trilinear axis there, those of the corners turned to the side of `like`; by the first of them where that is 0.
  [[nodiscard]] std::optional<Vec3> axis(const Vec3& p_W, const Vec3& like) const noexcept;

private:
  std::uint64_t revision_ = 0;
  std::uint64_t contentHash_ = 0;
  FieldBlockGrid grid_;
  std::vector<FieldBlockArray> arrays_;
  std::vector<Vec3> places_W_;
  std::vector<FieldBlockLine> lines_W_;
  std::shared_ptr<const FieldBlock> finer_;
  std::shared_ptr<const FieldCells> cells_;
};

} // namespace palpate
