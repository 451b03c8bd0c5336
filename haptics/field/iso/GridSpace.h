// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/iso/IsoSpace.h"
#include "haptics/field/iso/LevelSet.h"

namespace palpate
{

/// The cells of a uniform grid. The axes are the grid's.
class GridSpace : public IsoSpace
{
public:
  GridSpace(const FieldBlockComponent& field, const Vec3& spacing_u, const Vec3& device) noexcept
    : field_(field), h_u_(spacing_u), device_(device), hand_(GridPlace::at(device)), drawn_(hand_)
  {
  }

  [[nodiscard]] std::optional<GridPlace> within(const GridPlace& place) const noexcept override
  {
    return this->field_.within(place);
  }
  [[nodiscard]] TrilinearCell cell(const GridIndex& at, const IsoSide& of) const noexcept override
  {
    return this->field_.cell(at, of.level, of.side);
  }
  [[nodiscard]] Vec3 gradient_u(const TrilinearCell& cell, const GridPlace& at) const noexcept override
  {
    return cell.gradient(at.t).cwiseQuotient(this->h_u_);
  }
  [[nodiscard]] IsoRow row(
    const GridIndex& cell, const GridPlace& x, const IsoSide& of, const Vec3& q_u) const noexcept override;
  [[nodiscard]] FieldSweepResult sweep(
    const IsoSide& of, const GridPlace& from, const Vec3& way_u) const noexcept override
  {
    return sweepField({ this->field_, of.level, of.side }, from, way_u.cwiseQuotient(this->h_u_));
  }
  [[nodiscard]] Vec3 between_u(const GridPlace& from, const GridPlace& to) const noexcept override
  {
    return to.from(from).cwiseProduct(this->h_u_);
  }
  [[nodiscard]] double least_u(const GridPlace& /*at*/) const noexcept override { return this->h_u_.minCoeff(); }
  [[nodiscard]] double firstStep_u(const GridPlace& /*at*/) const noexcept override
  {
    constexpr double cells = 2.0;
    return cells * this->h_u_.minCoeff();
  }

  [[nodiscard]] std::optional<GridPlace> besideHand(const Vec3& shift_u) const noexcept override
  {
    return GridPlace::at(this->hand_.index() + shift_u.cwiseQuotient(this->h_u_));
  }
  [[nodiscard]] Vec3 toHand_u(const GridPlace& from) const noexcept override
  {
    return this->between_u(from, this->hand_);
  }
  [[nodiscard]] Vec3 fromHand_u(const GridPlace& to) const noexcept override
  {
    return this->between_u(this->hand_, to);
  }
  [[nodiscard]] Vec3 toDrawn_u(const GridPlace& from) const noexcept override
  {
    return this->between_u(from, this->drawn_);
  }
  void draw(const Vec3& shift_u) noexcept override
  {
    this->drawn_ = GridPlace::at(this->device_ + shift_u.cwiseQuotient(this->h_u_));
  }
  [[nodiscard]] double handWay_u(IsoState& state) const noexcept override
  {
    return this->between_u(state.device, this->hand_).norm();
  }
  void remember(IsoState& state) const noexcept override { state.device = this->hand_; }

private:
  FieldBlockComponent field_;
  Vec3 h_u_;
  Vec3 device_; ///< in index coordinates
  GridPlace hand_, drawn_;
};

} // namespace palpate
