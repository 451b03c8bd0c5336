// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "haptics/geometry/curves/CurveSet.h"

namespace palpate::lab
{

/// A point among lines as the labyrinths of the nineties had it: each line in turn is asked whether it lies between the
/// point and where it wants to go; the nearest that does moves the wish to its own nearest place; until none does.
/// With a size the point is put that far beside the line, without one it lies on it.
class IterateUntilFixed
{
public:
  IterateUntilFixed(const CurveSet& curves, double size_u) : curves_(curves), size_u_(size_u) {}

  void start(const Eigen::Vector2d& x_W) { this->x_W_ = x_W; }
  /// One tick towards p_W, at most mostSteps moves of the wish.
  void tick(const Eigen::Vector2d& p_W, int mostSteps);

  [[nodiscard]] const Eigen::Vector2d& x_W() const { return this->x_W_; }
  /// Where the wish was after each move of the last tick.
  [[nodiscard]] const std::vector<Eigen::Vector2d>& wishes_W() const { return this->wishes_W_; }

private:
  [[nodiscard]] bool moveWish(Eigen::Vector2d& wish_W) const;
  [[nodiscard]] Eigen::Vector2d placeOn(std::size_t segment, const Eigen::Vector2d& wish_W) const;

  CurveSet curves_;
  double size_u_;
  Eigen::Vector2d x_W_ = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> wishes_W_;
};

} // namespace palpate::lab
