// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/curves/MultiresolutionCurve.h"

#include <algorithm>
#include <utility>

#include "haptics/geometry/curves/CurveSimplification.h"

namespace palpate
{
namespace
{

std::uint32_t middle(std::uint32_t from, std::uint32_t to)
{
  return from + (to - from) / 2;
}

} // namespace

MultiresolutionCurve::MultiresolutionCurve(std::vector<Vec3> points_W) : points_W_(std::move(points_W))
{
  if (this->points_W_.size() >= 2)
  {
    this->divide();
    this->bound();
  }
}

void MultiresolutionCurve::divide()
{
  const auto last = static_cast<std::uint32_t>(this->points_W_.size() - 1);
  this->runs_.reserve(2 * this->points_W_.size());
  this->runs_.push_back({ 0, last });
  for (std::size_t i = 0; i < this->runs_.size(); ++i)
  {
    const CurveRun run = this->runs_[i];
    if (run.to - run.from > 1)
    {
      const std::uint32_t m = middle(run.from, run.to);
      this->runs_[i].halves = static_cast<std::uint32_t>(this->runs_.size());
      this->runs_.push_back({ run.from, m, 0, run.level + 1 });
      this->runs_.push_back({ m, run.to, 0, run.level + 1 });
    }
  }
}

void MultiresolutionCurve::bound()
{
  this->levelBound_u_.assign(static_cast<std::size_t>(this->runs_.back().level) + 1, 0.0);
  for (CurveRun& run : this->runs_)
  {
    const Vec3 &a_W = this->points_W_[run.from], &b_W = this->points_W_[run.to];
    for (std::uint32_t i = run.from + 1; i < run.to; ++i)
    {
      run.bound_u = std::max(run.bound_u, distanceToSegment(this->points_W_[i], a_W, b_W));
    }
    double& level_u = this->levelBound_u_[static_cast<std::size_t>(run.level)];
    level_u = std::max(level_u, run.bound_u);
  }
  // A half may be further off than the whole, for it has the whole's middle as an end.
  for (std::size_t level = this->levelBound_u_.size() - 1; level-- > 0;)
  {
    this->levelBound_u_[level] = std::max(this->levelBound_u_[level], this->levelBound_u_[level + 1]);
  }
}

template<class Enough>
std::vector<std::uint32_t> MultiresolutionCurve::cut(Enough enough) const
{
  std::vector<std::uint32_t> kept;
  std::vector<std::uint32_t> open;
  if (!this->runs_.empty())
  {
    kept.push_back(0);
    open.push_back(0);
  }
  while (!open.empty())
  {
    const CurveRun& run = this->runs_[open.back()];
    open.pop_back();
    if (!run.halves || enough(run))
    {
      kept.push_back(run.to);
      continue;
    }
    open.push_back(run.halves + 1);
    open.push_back(run.halves);
  }
  return kept;
}

std::vector<std::uint32_t> MultiresolutionCurve::level(int level) const
{
  return this->cut([level](const CurveRun& run) { return run.level == level; });
}

std::vector<std::uint32_t> MultiresolutionCurve::choose(const CurveDetail& detail) const
{
  return this->cut(
    [&](const CurveRun& run)
    {
      const double distance_u =
        distanceToSegment(detail.focus_W, this->points_W_[run.from], this->points_W_[run.to]) - run.bound_u;
      return run.bound_u <= detail.allowed_u(distance_u);
    });
}

} // namespace palpate
