// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/Roll.h"

#include <algorithm>
#include <array>
#include <limits>

namespace palpate
{
namespace
{

using Pivot = RollPlanner::Pivot;

/// Tangent of the largest angle by which n may turn towards w before the ball comes to lie on an incident face.
double coneLimit(const SurfaceData& s, const ActiveFeature& f, const Pivot& pivot) noexcept
{
  double limit = std::numeric_limits<double>::infinity();
  const auto include = [&](const Vec3& t)
  {
    const double turn = t.dot(pivot.w);
    if (turn > 0.0)
    {
      limit = std::min(limit, std::max(0.0, -t.dot(pivot.plane.n) / turn));
    }
  };
  if (f.kind == FeatureKind::Edge)
  {
    s.forEachAtEdge(f.a, f.b,
      [&](std::uint32_t triangle)
      {
        const Vec3 inward = s.vertex(s.opposite(triangle, f.a, f.b)) - s.vertex(f.a);
        include(inward - inward.dot(pivot.axis) * pivot.axis);
      });
    return limit;
  }
  for (std::uint32_t k = s.fanStart[f.a]; k < s.fanStart[f.a + 1]; ++k)
  {
    for (const std::uint32_t corner : s.mesh.triangles[s.fan[k]])
    {
      include(s.vertex(corner) - s.vertex(f.a));
    }
  }
  return limit;
}

/// The normal the ball is to have after the roll: towards what pulls it if that lies nearer than `within`, else
/// as far as the cone of the incident faces and the planner's largest turn allow.
Vec3 targetNormal(const Pivot& pivot, const Vec3& pull_W, double within) noexcept
{
  Vec3 v = pull_W - pivot.plane.foot_W;
  v -= v.dot(pivot.axis) * pivot.axis;
  const double along = v.dot(pivot.plane.n);
  if (v.squaredNorm() < within * within && along > 0.0 && v.dot(pivot.w) <= pivot.turn * along)
  {
    return v.normalized();
  }
  return (pivot.plane.n + pivot.turn * pivot.w).normalized();
}

/// Direction along which two touched planes leave the ball free, zero if they are parallel.
Vec3 freeDirection(const Vec3& n1, const Vec3& n2) noexcept
{
  const Vec3 t = n1.cross(n2);
  const double sine = t.norm();
  return sine > 1e-6 ? Vec3(t / sine) : Vec3(Vec3::Zero());
}

} // namespace

RollPlanner::RollPlanner(
  const ContactSet& contacts, const Vec3& x_W, const Vec3& p_W, double radius_u, const ProjectionResult& solution,
  double mostTurn) noexcept
  : contacts_(contacts)
  , x_W_(x_W)
  , q_(p_W - x_W)
  , radius_u_(radius_u)
  , solution_(solution)
  , mostTurn_(mostTurn)
  , slack_(0.25 * contacts.resolution().tol())
{
  for (int i = 0; i < contacts.count(); ++i)
  {
    this->rows_[i] = this->both_[i] = contacts.row(i, 0.0);
  }
}

/// Where the ball is drawn to: the device, or, in the crevice of two contacts of which one is round, the Newton
/// step of the constrained problem. Its Hessian along the crevice t is 1 - sum l (1 - (t.e)^2) / r: the plain step
/// would converge like 1 - H only.
Vec3 RollPlanner::aim() noexcept
{
  if (this->solution_.count != 2)
  {
    return this->q_;
  }
  const Vec3 t = freeDirection(this->rows_[this->solution_.active[0]].n, this->rows_[this->solution_.active[1]].n);
  double hessian = 1.0;
  for (int k = 0; k < 2; ++k)
  {
    const ActiveFeature& f = this->contacts_.features()[this->solution_.active[k]];
    if (f.kind != FeatureKind::Face)
    {
      const double along = f.kind == FeatureKind::Edge ? t.dot(this->axisOf(f)) : 0.0;
      hessian -= this->solution_.lambda[k] * (1.0 - along * along) / this->radius_u_;
    }
  }
  constexpr double convexEnough = 0.01;
  this->newton_ = !t.isZero(0.0) && hessian >= convexEnough && hessian < 1.0;
  return this->newton_ ? Vec3(this->solution_.y.dot(t) / hessian * t) : this->q_;
}

Vec3 RollPlanner::axisOf(const ActiveFeature& f) const noexcept
{
  return f.kind == FeatureKind::Edge ? edgeLine(this->contacts_.dataOf(f), f.a, f.b).unit : Vec3(Vec3::Zero());
}

void RollPlanner::chooseTargets(Vec3& aim) noexcept
{
  for (int k = 0; k < this->solution_.count; ++k)
  {
    const int i = this->solution_.active[k];
    const ActiveFeature& f = this->contacts_.features()[i];
    if (f.kind == FeatureKind::Face || this->solution_.lambda[k] <= 0.0)
    {
      continue;
    }
    const Vec3& y = this->newton_ ? aim : this->solution_.y;
    Pivot pivot{ i, this->contacts_.plane(f), this->axisOf(f) };
    pivot.w = y - y.dot(pivot.plane.n) * pivot.plane.n;
    pivot.w -= pivot.w.dot(pivot.axis) * pivot.axis;
    const double reach = pivot.w.norm();
    if (reach <= 4 * this->slack_)
    {
      continue;
    }
    pivot.w /= reach;
    const Vec3 pull = this->newton_ ? aim : Vec3(this->solution_.y - this->solution_.lambda[k] * pivot.plane.n);
    pivot.limit = coneLimit(this->contacts_.dataOf(f), f, pivot);
    pivot.turn = std::min(pivot.limit, this->mostTurn_);
    if (this->newton_ && reach > pivot.turn * this->radius_u_)
    {
      aim *= pivot.turn * this->radius_u_ / reach; // not beyond the face or edge it will come to lie on
    }
    const Vec3 n = targetNormal(pivot, this->x_W_ + pull, this->newton_ ? 2 * this->radius_u_ + reach : this->radius_u_);
    if ((n - pivot.plane.n).norm() * this->radius_u_ > 4 * this->slack_)
    {
      this->rows_[i] = { n, this->radius_u_ - n.dot(this->x_W_ - pivot.plane.foot_W) };
      this->pivots_[this->pivotCount_++] = pivot;
    }
  }
}

/// Re-linearises the target planes where the ball comes to lie on them. True when nothing is left to correct.
bool RollPlanner::correct(const Vec3& y) noexcept
{
  bool settled = true;
  for (int k = 0; k < this->pivotCount_; ++k)
  {
    const Pivot& pivot = this->pivots_[k];
    Vec3 away = this->x_W_ + y - pivot.plane.foot_W;
    away -= away.dot(pivot.axis) * pivot.axis;
    const double distance = away.norm();
    const Vec3 n = away / distance;
    const bool insideCone = n.dot(pivot.w) <= pivot.limit * n.dot(pivot.plane.n);
    if (insideCone && distance - this->radius_u_ > this->slack_)
    {
      this->rows_[pivot.row] = { n, this->radius_u_ - n.dot(this->x_W_ - pivot.plane.foot_W) };
      settled = false;
    }
  }
  return settled;
}

/// A target that keeps the place y along the crevice and presses into the holding planes as they are now.
Vec3 RollPlanner::pressed(const Vec3& y) const noexcept
{
  Vec3 target = y;
  for (int k = 0; k < this->solution_.count; ++k)
  {
    target -= this->radius_u_ * this->rows_[this->solution_.active[k]].n;
  }
  return target;
}

RollPlan RollPlanner::plan() noexcept
{
  RollPlan plan;
  Vec3 aim = this->aim();
  this->chooseTargets(aim);
  if (this->pivotCount_ == 0)
  {
    return plan;
  }
  const auto count = static_cast<std::size_t>(this->contacts_.count());
  Vec3 target = this->newton_ ? this->pressed(aim) : aim;
  ProjectionResult second = projectOntoPlanes({ this->rows_.data(), count }, target, this->slack_);
  constexpr int corrections = 4;
  for (int k = 0; k < corrections && second.feasible && !this->correct(second.y); ++k)
  {
    target = this->pressed(second.y);
    second = projectOntoPlanes({ this->rows_.data(), count }, target, this->slack_);
  }
  for (int k = 0; k < this->pivotCount_; ++k)
  {
    this->both_[count + k] = this->rows_[this->pivots_[k].row];
    plan.turn = std::max(plan.turn, this->pivots_[k].turn);
  }
  const ProjectionResult first = projectOntoPlanes({ this->both_.data(), count + this->pivotCount_ }, target, this->slack_);
  // Near the solution a Newton step gains less than a distance resolves.
  plan.tolerance_u2 = this->newton_ ? 4 * this->slack_ * this->q_.norm() : 0.0;
  plan.worthwhile = first.feasible && second.feasible &&
    (second.y - this->q_).squaredNorm() < this->q_.squaredNorm() + plan.tolerance_u2;
  plan.first = first.y;
  plan.second = second.y;
  return plan;
}

} // namespace palpate
