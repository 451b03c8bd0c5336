// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/labyrinth/CorridorWidth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include "haptics/geometry/curves/CurveSimplification.h"

namespace palpate
{
namespace
{

constexpr int stepsAlong = 512;

Vec3 inSpace(const Eigen::Vector2d& p_W)
{
  return { p_W.x(), p_W.y(), 0.0 };
}

/// Square cells over the fence, and how far the middle of each is from the nearest line.
class Clearances
{
public:
  Clearances(const CurveSet& curves, const PlaneBox& box)
    : curves_(curves), low_W_(box.low_W), step_u_((box.high_W - box.low_W).maxCoeff() / stepsAlong)
  {
    const Eigen::Vector2d cells = (box.high_W - box.low_W) / this->step_u_;
    this->columns_ = std::clamp(static_cast<int>(std::ceil(cells.x())), 1, stepsAlong);
    this->rows_ = std::clamp(static_cast<int>(std::ceil(cells.y())), 1, stepsAlong);
    this->clearance_u_.assign(static_cast<std::size_t>(this->columns_) * static_cast<std::size_t>(this->rows_),
      std::numeric_limits<double>::infinity());
    for (std::size_t segment = 0; segment < curves.segments.size(); ++segment)
    {
      this->begin(segment);
    }
    this->spread();
  }

  [[nodiscard]] double step_u() const { return this->step_u_; }

  [[nodiscard]] int cellOf(const Eigen::Vector2d& p_W) const
  {
    const Eigen::Vector2d at = (p_W - this->low_W_) / this->step_u_;
    const int column = std::clamp(static_cast<int>(at.x()), 0, this->columns_ - 1);
    return std::clamp(static_cast<int>(at.y()), 0, this->rows_ - 1) * this->columns_ + column;
  }

  /// The least clearance along the path between two cells on which that is largest [u].
  [[nodiscard]] double widestBetween(int from, int to) const
  {
    std::vector<double> reached_u(this->clearance_u_.size(), -1.0);
    std::priority_queue<std::pair<double, int>> next;
    const auto reach = [&](int cell, double way_u)
    {
      const double width_u = std::min(way_u, this->clearance_u_[static_cast<std::size_t>(cell)]);
      if (width_u > reached_u[static_cast<std::size_t>(cell)])
      {
        reached_u[static_cast<std::size_t>(cell)] = width_u;
        next.emplace(width_u, cell);
      }
    };
    reach(from, std::numeric_limits<double>::infinity());
    while (next.top().second != to)
    {
      const auto [width_u, cell] = next.top();
      next.pop();
      this->forEachBeside(cell, [&](int beside) { reach(beside, width_u); });
    }
    return next.top().first;
  }

private:
  [[nodiscard]] double distance_u(int cell, std::size_t segment) const
  {
    const Eigen::Vector2d middle_W =
      this->low_W_ + this->step_u_ * Eigen::Vector2d(cell % this->columns_ + 0.5, cell / this->columns_ + 0.5);
    const auto& [a, b] = this->curves_.segments[segment];
    return distanceToSegment(inSpace(middle_W), inSpace(this->curves_.points_W[a]), inSpace(this->curves_.points_W[b]));
  }

  void offer(int cell, std::size_t segment)
  {
    const double distance = this->distance_u(cell, segment);
    if (distance < this->clearance_u_[static_cast<std::size_t>(cell)])
    {
      this->clearance_u_[static_cast<std::size_t>(cell)] = distance;
      this->near_.emplace(-distance, cell, segment);
    }
  }

  /// At the cells that a segment passes.
  void begin(std::size_t segment)
  {
    const auto& [a, b] = this->curves_.segments[segment];
    const Eigen::Vector2d from_W = this->curves_.points_W[a], way_W = this->curves_.points_W[b] - from_W;
    const int pieces = 1 + static_cast<int>(2.0 * way_W.norm() / this->step_u_);
    for (int i = 0; i <= pieces; ++i)
    {
      this->offer(this->cellOf(from_W + (static_cast<double>(i) / pieces) * way_W), segment);
    }
  }

  /// From near to far each cell tells its neighbours of its nearest segment.
  void spread()
  {
    while (!this->near_.empty())
    {
      const auto [distance, cell, segment] = this->near_.top();
      this->near_.pop();
      if (-distance <= this->clearance_u_[static_cast<std::size_t>(cell)])
      {
        this->forEachBeside(cell, [&, segment = segment](int beside) { this->offer(beside, segment); });
      }
    }
  }

  template<class Visit>
  void forEachBeside(int cell, Visit visit) const
  {
    const int column = cell % this->columns_, row = cell / this->columns_;
    if (column > 0)
    {
      visit(cell - 1);
    }
    if (column + 1 < this->columns_)
    {
      visit(cell + 1);
    }
    if (row > 0)
    {
      visit(cell - this->columns_);
    }
    if (row + 1 < this->rows_)
    {
      visit(cell + this->columns_);
    }
  }

  const CurveSet& curves_;
  Eigen::Vector2d low_W_;
  double step_u_;
  int columns_ = 0, rows_ = 0;
  std::vector<double> clearance_u_;
  std::priority_queue<std::tuple<double, int, std::size_t>> near_; ///< the nearest first
};

} // namespace

std::optional<double> corridorWidth(const Labyrinth& labyrinth)
{
  if (!refuse(labyrinth).empty())
  {
    return std::nullopt;
  }
  const CurveSet curves = fenced(labyrinth);
  const PlaneBox box = fence(labyrinth);
  if (!((box.high_W - box.low_W).maxCoeff() > 0.0) || !(box.high_W - box.low_W).allFinite()) // a dot, or an overflow
  {
    return std::nullopt;
  }
  const Clearances clearances(curves, box);
  const double half_u =
    clearances.widestBetween(clearances.cellOf(*labyrinth.start_W), clearances.cellOf(*labyrinth.exit_W));
  // A line between two cells is within half a step of one of them: a path that keeps farther off crosses none.
  return half_u > 0.5 * clearances.step_u() ? std::optional<double>(2.0 * half_u) : std::nullopt;
}

} // namespace palpate
