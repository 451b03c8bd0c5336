// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/cells/FieldCells.h"
#include "haptics/field/iso/IsoSpace.h"

namespace palpate
{

/// The data's own cells. The axes are those of W. The device of a state is the hand in W, as the local place of no
/// cell.
class CellSpace : public IsoSpace
{
public:
  CellSpace(const FieldCells& cells, const Vec3& hand_W) noexcept : cells_(cells), hand_W_(hand_W), drawn_W_(hand_W) {}

  [[nodiscard]] std::optional<GridPlace> within(const GridPlace& place) const noexcept override
  {
    return this->cells_.holds(place.cell) ? std::optional(place) : std::nullopt;
  }
  [[nodiscard]] TrilinearCell cell(const GridIndex& at, const IsoSide& of) const noexcept override
  {
    return this->cells_.cell(at, of.level, of.side);
  }
  [[nodiscard]] Vec3 gradient_u(const TrilinearCell& cell, const GridPlace& at) const noexcept override;
  [[nodiscard]] IsoRow row(
    const GridIndex& cell, const GridPlace& x, const IsoSide& of, const Vec3& q_u) const noexcept override;
  /// Straight in each cell's own coordinates, which is to a rounding straight where cells are, and anew towards the end
  /// in each cell: along such a curve the scalar is a cubic whatever the cell's shape is.
  [[nodiscard]] FieldSweepResult sweep(
    const IsoSide& of, const GridPlace& from, const Vec3& way_u) const noexcept override;
  [[nodiscard]] Vec3 between_u(const GridPlace& from, const GridPlace& to) const noexcept override
  {
    return this->cells_.toWorld(to) - this->cells_.toWorld(from);
  }
  [[nodiscard]] double least_u(const GridPlace& at) const noexcept override;
  [[nodiscard]] double rounded_u(const GridPlace& at) const noexcept override
  {
    return this->least_u(at) + this->cells_.toWorld(at).cwiseAbs().maxCoeff();
  }
  [[nodiscard]] double firstStep_u(const GridPlace& at) const noexcept override
  {
    return this->cells_.map(at.cell).size_u();
  }
  [[nodiscard]] std::optional<GridPlace> besideHand(const Vec3& shift_u) const noexcept override
  {
    return this->cells_.locate(this->hand_W_ + shift_u);
  }
  [[nodiscard]] Vec3 toHand_u(const GridPlace& from) const noexcept override
  {
    return this->hand_W_ - this->cells_.toWorld(from);
  }
  [[nodiscard]] Vec3 fromHand_u(const GridPlace& to) const noexcept override
  {
    return this->cells_.toWorld(to) - this->hand_W_;
  }
  [[nodiscard]] Vec3 toDrawn_u(const GridPlace& from) const noexcept override
  {
    return this->drawn_W_ - this->cells_.toWorld(from);
  }
  void draw(const Vec3& shift_u) noexcept override { this->drawn_W_ = this->hand_W_ + shift_u; }
  [[nodiscard]] double handWay_u(IsoState& state) const noexcept override
  {
    return (this->hand_W_ - state.device.t).norm();
  }
  void remember(IsoState& state) const noexcept override { state.device = { {}, this->hand_W_ }; }

private:
  /// The cell, another than `other`, that a sweep is in a step further on.
  [[nodiscard]] std::optional<GridPlace> ahead(
    const GridPlace& at, const Vec3& left_u, double step_u, int other) const noexcept;
  /// Where a sweep goes on beyond a face; none where the cells end.
  [[nodiscard]] std::optional<GridPlace> beyond(const GridPlace& at, int face, const Vec3& left_u) const noexcept;
  /// Likewise of a sweep that goes along an edge, and so from cell to cell around it.
  [[nodiscard]] std::optional<GridPlace> offEdge(const GridPlace& at, const Vec3& left_u) const noexcept;

  const FieldCells& cells_;
  Vec3 hand_W_, drawn_W_;
};

} // namespace palpate
