// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/move/StepPlan.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

constexpr double longestTurn_rad = 0.2; // of a step
constexpr double largestDip = 0.3;      // of the rest gap: half of it is spare
constexpr double dipOfBend = 0.25;      // f'' / 8 in the middle of a step that ends f'' / 2 off its line
constexpr int corrections = 2;

/// The least rise of a row's line over the step, for a gap that also bends by bend_u. The gap ends at the rest
/// gap. A gap that bends away from the scene may shrink during the step by no more than its dip; a pair that has less
/// than that to spare has to rise along its line at once, because a pair at the proven gap whose line does not rise
/// could not be proven over the start of any step, and the tool would never leave.
double leastRise_u(double gap_u, double bend_u, double restGap_u)
{
  const double least_u = restGap_u - gap_u - bend_u;
  const double spare_u = gap_u - (1.0 - largestDip) * restGap_u;
  if (bend_u <= std::max(0.0, spare_u))
  {
    return least_u;
  }
  // gap + r s + bend s^2 is least at s = -r / (2 bend), within the step if the bend is larger than the spare part.
  return std::max(least_u, spare_u > 0.0 ? -2.0 * std::sqrt(bend_u * spare_u) : -spare_u);
}

} // namespace

ScrewStep StepPlan::stepOf(const Vec6& y) const
{
  return { this->from_W_, y.head<3>(), y.tail<3>() / this->limits_.characteristic_u };
}

NearestMotion StepPlan::solve(const Vec6& wish, const std::vector<double>& bends_u) const
{
  std::vector<MotionRow> rows(this->rows_.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const TouchRow& row = this->rows_[i];
    const double least_u = leastRise_u(row.offset_u, bends_u[i], this->limits_.restGap_u);
    rows[i] = motionRow(row.plane.n_W, row.plane.arm_W, least_u, this->limits_.characteristic_u);
  }
  NearestMotion found = nearestMotion(rows, wish);
  if (!found.feasible)
  {
    for (MotionRow& row : rows) // a fit with less clearance than two rest gaps: to stay is always allowed
    {
      row.bound = std::min(row.bound, 0.0);
    }
    found = nearestMotion(rows, wish);
  }
  for (int i = 0; i < found.count; ++i)
  {
    const TouchPlane& plane = this->rows_[found.row[i]].plane;
    const double turning = plane.arm_W.cross(plane.n_W).norm() / this->limits_.characteristic_u;
    found.pressure[i] /= std::sqrt(1.0 + turning * turning);
  }
  return found;
}

std::vector<double> StepPlan::bendsOf(const ScrewStep& step) const
{
  const Pose end_W = step.end_W(1.0);
  const Mat3 turn = end_W.q.toRotationMatrix();
  std::vector<double> bends_u(this->rows_.size());
  for (std::size_t i = 0; i < bends_u.size(); ++i)
  {
    const TouchRow& row = this->rows_[i];
    bends_u[i] = planeAt(row.feature, turn, end_W.p).gap_u - row.linear_u(step);
  }
  return bends_u;
}

/// The share of a step that its lengths and the bends of its rows allow.
double StepPlan::shareAllowed(const ScrewStep& step) const
{
  const double turn_rad = step.w_W.norm(), way_u = step.displacement_u(this->limits_.reach_u);
  double share = 1.0;
  share = turn_rad > longestTurn_rad ? std::min(share, longestTurn_rad / turn_rad) : share;
  share = way_u > this->limits_.room_u ? std::min(share, this->limits_.room_u / way_u) : share;
  const std::vector<double> bends_u = this->bendsOf({ step.from_W, share * step.v_W, share * step.w_W });
  const Mat3 turn = this->from_W_.q.toRotationMatrix();
  double dips = 1.0;
  for (std::size_t i = 0; i < bends_u.size(); ++i)
  {
    const double dip = dipOfBend * bends_u[i];
    // A feature that does not touch yet approaches by its gap, which allows a dip before the end of the step.
    const double spare =
      dipOfBend * (planeAt(this->rows_[i].feature, turn, this->from_W_.p).gap_u - this->limits_.restGap_u);
    const double most = std::max(largestDip * this->limits_.restGap_u, spare);
    if (dip > most)
    {
      dips = std::min(dips, std::sqrt(most / dip));
    }
  }
  return share * dips;
}

PlannedStep StepPlan::plan(const Vec6& wish) const
{
  PlannedStep planned;
  const NearestMotion found = this->solve(wish, std::vector<double>(this->rows_.size(), 0.0));
  planned.full = found.y;
  planned.pressures.assign(this->rows_.size(), 0.0);
  for (int i = 0; i < found.count; ++i)
  {
    planned.pressures[found.row[i]] = found.pressure[i];
  }
  const Vec6 towards = this->shareAllowed(this->stepOf(found.y)) * found.y;
  planned.step = this->stepOf(towards);
  for (int i = 0; i < corrections && !this->rows_.empty(); ++i)
  {
    planned.step = this->stepOf(this->solve(towards, this->bendsOf(planned.step)).y);
  }
  const double way_u = planned.step.displacement_u(this->limits_.reach_u);
  if (way_u > this->limits_.room_u)
  {
    planned.step.v_W *= this->limits_.room_u / way_u;
    planned.step.w_W *= this->limits_.room_u / way_u;
  }
  return planned;
}

} // namespace palpate
