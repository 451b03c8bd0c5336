// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// How finely a curve is wanted: limit_u where it may be felt, coarser with the distance beyond.
struct CurveDetail
{
  Vec3 focus_W = Vec3::Zero(); ///< where the hand is
  double limit_u =
    0.0; ///< error allowed within reach; the imperceptible error is the smallest force divided by the stiffness
  double reach_u = 0.0; ///< how far from the focus the hand may touch before the choice is made again
  double growth = 0.0;  ///< error allowed per distance beyond reach

  [[nodiscard]] double allowed_u(double distance_u) const noexcept
  {
    return this->limit_u + (distance_u > this->reach_u ? this->growth * (distance_u - this->reach_u) : 0.0);
  }
};

/// A run of a curve from one of its points to another, for which the segment between these two may stand.
struct CurveRun
{
  std::uint32_t from = 0, to = 0;
  std::uint32_t halves = 0; ///< index of the first of two, one after the other; 0: a segment of the curve
  int level = 0;
  double bound_u = 0.0; ///< no point of the run is further from the segment, or the segment's from the run [u]
};

/// A polyline at many levels of detail, after Pai & Reissel 1997: each level halves the points of the one below, and
/// the points that are left out bound its error. The bound of a run is the distance of its farthest point from the
/// segment that stands for the run. The bound is proven for run and segment alike: the distance to a segment is convex,
/// so a part between two points is as near, and the nearest points run without a gap from one end of the segment to
/// the other. Sums of the details left out level by level, which need not look at every point, would be larger: for
/// noise as many times as there are levels.
///
/// Neighbouring runs share an end, so a choice of runs is one polyline without gaps. Two choices are nested, so they
/// differ nowhere by more than the larger bound in use there. If all that can be touched is within limit_u, a change of
/// level moves nothing by more than limit_u.
class MultiresolutionCurve
{
public:
  MultiresolutionCurve() = default;
  /// At least two finite points [u]; of fewer nothing is made. O(n log n).
  explicit MultiresolutionCurve(std::vector<Vec3> points_W);

  [[nodiscard]] const std::vector<Vec3>& points_W() const noexcept { return this->points_W_; }

  /// Levels from 0, one segment, to levels() - 1, every point.
  [[nodiscard]] int levels() const noexcept { return static_cast<int>(this->levelBound_u_.size()); }
  /// Indices of the points of a level, ascending.
  [[nodiscard]] std::vector<std::uint32_t> level(int level) const;
  /// The whole first, halves behind their parent.
  [[nodiscard]] const std::vector<CurveRun>& runs() const noexcept { return this->runs_; }
  /// No run of this level or a finer one has a larger bound [u]; falls from level to level and is 0 at the last.
  [[nodiscard]] double bound_u(int level) const noexcept
  {
    return this->levelBound_u_[static_cast<std::size_t>(level)];
  }

  /// Points of the coarsest choice of runs that is nowhere farther from the curve than allowed there, ascending. The
  /// distance of a run from the focus is that of its segment less its bound, so no run is taken for farther than it is.
  [[nodiscard]] std::vector<std::uint32_t> choose(const CurveDetail& detail) const;

private:
  void divide();
  void bound();
  /// The points at the ends of the first runs, from the whole down, that `enough` says yes to.
  template<class Enough>
  [[nodiscard]] std::vector<std::uint32_t> cut(Enough enough) const;

  std::vector<Vec3> points_W_;
  std::vector<CurveRun> runs_;
  std::vector<double> levelBound_u_;
};

} // namespace palpate
