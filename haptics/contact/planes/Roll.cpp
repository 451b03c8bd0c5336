// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/planes/Roll.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{

struct ConeLimit
{
  double tangent = std::numeric_limits<double>::infinity();
  Vec3 into = Vec3::Zero(); ///< from the pivot along the face or edge that sets the limit
};

/// The largest angle by which n may turn towards w before the ball comes to lie on an incident face.
template<class View>
ConeLimit coneLimit(const View& s, const ActiveFeature& f, const RollPivot& pivot) noexcept
{
  ConeLimit limit;
  if (f.kind == FeatureKind::Edge && dataOf(s).coat_u > 0.0)
  {
    return limit; // nothing lies at the side of a curve
  }
  const auto include = [&](const Vec3& t)
  {
    const double turn = t.dot(pivot.w);
    const double tangent = turn > 0.0 ? std::max(0.0, -t.dot(pivot.plane.n) / turn) : limit.tangent;
    if (tangent < limit.tangent)
    {
      limit = { tangent, t };
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
  s.forEachAround(f.a,
    [&](std::uint32_t triangle)
    {
      for (const std::uint32_t corner : s.corners(triangle))
      {
        include(s.vertex(corner) - s.vertex(f.a));
      }
    });
  return limit;
}

/// The normal the ball is to have after the roll: towards the target if that lies nearer than `within`, else
/// as far as the cone of the incident faces and the planner's largest turn allow.
Vec3 targetNormal(const RollPivot& pivot, const Vec3& pull_W, double within) noexcept
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
  constexpr double parallel = 1e-6; // below, the direction is known to less than a ten-thousandth of a degree
  return sine > parallel ? Vec3(t / sine) : Vec3(Vec3::Zero());
}

} // namespace

template<SceneView AnyScene>
RollPlanner<AnyScene>::RollPlanner(const ContactSet<AnyScene>& contacts, const Vec3& x_W, const Vec3& p_W,
  double radius_u, const ProjectionResult& solution, double mostTurn) noexcept
  : contacts_(contacts), x_W_(x_W), q_(p_W - x_W), radius_u_(radius_u), solution_(solution), mostTurn_(mostTurn),
    slack_(contacts.resolution().slack()) // 4 of them are a way of tol, which is none
{
  for (int i = 0; i < contacts.count(); ++i)
  {
    this->rows_[i] = this->both_[i] = contacts.row(i, 0.0);
  }
}

/// How far along aim edge or vertex f goes on holding the ball.
template<SceneView AnyScene>
double RollPlanner<AnyScene>::heldFraction(const ActiveFeature& f, const Vec3& aim) const noexcept
{
  if (f.kind != FeatureKind::Edge)
  {
    return 1.0;
  }
  const Vec3 along = aim.dot(this->axisOf(f)) * this->axisOf(f);
  return exitRound(
    this->contacts_.surface(f), f, this->x_W_, along, this->radius_u_, this->contacts_.resolution().del());
}

/// Cuts aim to where face f ends, and remembers its border: the ball is to land just outside of it.
template<SceneView AnyScene>
void RollPlanner<AnyScene>::cutToFace(const ActiveFeature& f, Vec3& aim) noexcept
{
  const auto& s = this->contacts_.surface(f);
  const FaceExit exit = walkFace(s, f.a, this->x_W_, aim, this->contacts_.resolution().del());
  if (exit.t >= 1.0)
  {
    return;
  }
  aim *= exit.t;
  const auto& corners = s.corners(exit.triangle);
  for (int k = 0; k < 3; ++k)
  {
    if (std::min(corners[k], corners[(k + 1) % 3]) == exit.i && std::max(corners[k], corners[(k + 1) % 3]) == exit.j)
    {
      this->border_ = { outwardNormal(s, exit.triangle, k), s.vertex(exit.i) };
      this->hasBorder_ = true;
    }
  }
}

/// The step along the crevice is straight, the ball's way is not. Shifts the aim so that the ball lands just beyond the
/// border to which the aim was cut. True when y lands there already.
template<SceneView AnyScene>
bool RollPlanner<AnyScene>::landOnBorder(const Vec3& y, Vec3& aim) const noexcept
{
  const double del = this->contacts_.resolution().del();
  const double wanted = 4 * del; // as far outside as a slide ends, see walkFace()
  const double outside = this->border_.outward.dot(this->x_W_ + y - this->border_.point_W);
  const double rate = this->border_.outward.dot(aim);
  if (std::fabs(outside - wanted) <= 3 * del || std::fabs(outside - wanted) >= 0.5 * std::fabs(rate))
  {
    return true;
  }
  aim *= 1.0 + (wanted - outside) / rate;
  return false;
}

/// In the crevice of two contacts of which one is round: the Newton step of the constrained problem. Its Hessian
/// along the crevice t is 1 - sum l (1 - (t.e)^2) / r; the plain step would converge like 1 - H only. On a saddle
/// (H <= 0) as far as the contacts hold.
template<SceneView AnyScene>
Vec3 RollPlanner<AnyScene>::creviceAim() noexcept
{
  const Vec3 t = freeDirection(this->rows_[this->solution_.active[0]].n, this->rows_[this->solution_.active[1]].n);
  double hessian = 1.0, roundest = 0.0;
  for (int k = 0; k < 2; ++k)
  {
    const ActiveFeature& f = this->contacts_.features()[this->solution_.active[k]];
    roundest = std::max(roundest, this->contacts_.radius(f));
    if (f.kind != FeatureKind::Face)
    {
      const double along = t.dot(this->axisOf(f));
      hessian -= this->solution_.lambda[k] * (1.0 - along * along) / this->contacts_.radius(f);
    }
  }
  // Below, a Newton step would be more than a hundred times the plain one, or lead back. There the aim is put ten
  // radii away instead, and cut to where the contacts end.
  constexpr double flat = 0.01;
  const double pull = this->solution_.y.dot(t);
  const double step = hessian > flat ? pull / hessian : std::copysign(10 * roundest, pull);
  Vec3 aim = step * t;
  for (int k = 0; k < 2; ++k)
  {
    const ActiveFeature& f = this->contacts_.features()[this->solution_.active[k]];
    if (f.kind == FeatureKind::Face)
    {
      this->cutToFace(f, aim);
    }
    else
    {
      aim *= this->heldFraction(f, aim);
    }
  }
  return aim;
}

template<SceneView AnyScene>
Vec3 RollPlanner<AnyScene>::axisOf(const ActiveFeature& f) const noexcept
{
  return f.kind == FeatureKind::Edge ? edgeLine(this->contacts_.surface(f), f.a, f.b).unit : Vec3(Vec3::Zero());
}

/// The round contacts that turn, and the normals they are to have; aim is cut to the limits of their cones.
template<SceneView AnyScene>
void RollPlanner<AnyScene>::chooseTargets(Vec3& aim) noexcept
{
  const bool crevice = this->solution_.count == 2;
  for (int k = 0; k < this->solution_.count; ++k)
  {
    const int i = this->solution_.active[k];
    const ActiveFeature& f = this->contacts_.features()[i];
    if (f.kind == FeatureKind::Face || this->solution_.lambda[k] <= 0.0)
    {
      continue;
    }
    RollPivot pivot{ i, this->contacts_.plane(f), this->axisOf(f) };
    pivot.radius = this->contacts_.radius(f);
    pivot.w = aim - aim.dot(pivot.plane.n) * pivot.plane.n;
    pivot.w -= pivot.w.dot(pivot.axis) * pivot.axis;
    const double reach = pivot.w.norm();
    if (reach <= 4 * this->slack_)
    {
      continue;
    }
    pivot.w /= reach;
    const ConeLimit cone = coneLimit(this->contacts_.surface(f), f, pivot);
    pivot.limit = cone.tangent;
    pivot.turn = std::min(pivot.limit, this->mostTurn_);
    if (crevice && reach > pivot.turn * pivot.radius)
    {
      aim *= pivot.turn * pivot.radius / reach; // not beyond the face or edge it will come to lie on
      this->hasBorder_ = pivot.turn == pivot.limit && pivot.limit > 0.0;
      this->border_ = this->hasBorder_ ? RollBorder{ cone.into.normalized(), pivot.plane.foot_W } : RollBorder{};
    }
    const Vec3 pull = crevice ? aim : Vec3(this->solution_.y - this->solution_.lambda[k] * pivot.plane.n);
    const Vec3 n = targetNormal(pivot, this->x_W_ + pull, crevice ? 2 * pivot.radius + reach : pivot.radius);
    if ((n - pivot.plane.n).norm() * pivot.radius > 4 * this->slack_)
    {
      this->rows_[i] = { n, pivot.radius - n.dot(this->x_W_ - pivot.plane.foot_W) };
      this->pivots_[this->pivotCount_++] = pivot;
    }
  }
}

/// A single round contact: along the arc to the point where it has its new normal, and along the edge to its end.
template<SceneView AnyScene>
Vec3 RollPlanner<AnyScene>::arcAim() const noexcept
{
  const RollPivot& pivot = this->pivots_[0];
  const Vec3 along = this->solution_.y.dot(pivot.axis) * pivot.axis;
  return pivot.radius * (this->rows_[pivot.row].n - pivot.plane.n) +
         this->heldFraction(this->contacts_.features()[pivot.row], along) * along;
}

/// Re-linearises the target planes where the ball comes to lie on them. True when nothing is left to correct.
template<SceneView AnyScene>
bool RollPlanner<AnyScene>::correct(const Vec3& y) noexcept
{
  bool settled = true;
  for (int k = 0; k < this->pivotCount_; ++k)
  {
    const RollPivot& pivot = this->pivots_[k];
    Vec3 away = this->x_W_ + y - pivot.plane.foot_W;
    away -= away.dot(pivot.axis) * pivot.axis;
    const double distance = away.norm();
    const Vec3 n = away / distance;
    const bool insideCone = n.dot(pivot.w) <= pivot.limit * n.dot(pivot.plane.n);
    if (insideCone && distance - pivot.radius > this->slack_)
    {
      this->rows_[pivot.row] = { n, pivot.radius - n.dot(this->x_W_ - pivot.plane.foot_W) };
      settled = false;
    }
  }
  return settled;
}

/// A target that keeps the place y along the crevice and presses into the holding planes as they are now.
template<SceneView AnyScene>
Vec3 RollPlanner<AnyScene>::pressed(const Vec3& y) const noexcept
{
  Vec3 target = y;
  for (int k = 0; k < this->solution_.count; ++k)
  {
    const int i = this->solution_.active[k];
    target -= this->contacts_.radius(this->contacts_.features()[i]) * this->rows_[i].n;
  }
  return target;
}

template<SceneView AnyScene>
ProjectionResult RollPlanner<AnyScene>::nearest(std::span<const PlaneRow> rows, const Vec3& target) noexcept
{
  const ProjectionResult result = projectOntoPlanes(rows, target, this->slack_);
  this->sets_ += result.sets;
  return result;
}

template<SceneView AnyScene>
RollPlan RollPlanner<AnyScene>::plan() noexcept
{
  RollPlan plan;
  const bool crevice = this->solution_.count == 2;
  Vec3 aim = crevice ? this->creviceAim() : this->solution_.y;
  this->chooseTargets(aim);
  if (this->pivotCount_ == 0)
  {
    return plan;
  }
  const auto count = static_cast<std::size_t>(this->contacts_.count());
  Vec3 target = crevice ? this->pressed(aim) : (this->solution_.count == 1 ? this->pressed(this->arcAim()) : this->q_);
  ProjectionResult second = this->nearest({ this->rows_.data(), count }, target);
  constexpr int corrections = 10; // the steps converge quadratically, in 2 to 4; the rest bounds those that do not
  for (int k = 0; k < corrections && second.feasible; ++k)
  {
    const bool corrected = this->correct(second.y);
    if (corrected && (!this->hasBorder_ || this->landOnBorder(second.y, aim)))
    {
      break;
    }
    target = this->pressed(this->hasBorder_ ? aim : second.y);
    second = this->nearest({ this->rows_.data(), count }, target);
  }
  for (int k = 0; k < this->pivotCount_; ++k)
  {
    this->both_[count + k] = this->rows_[this->pivots_[k].row];
    plan.turn = std::max(plan.turn, this->pivots_[k].turn);
  }
  const ProjectionResult first = this->nearest({ this->both_.data(), count + this->pivotCount_ }, target);
  // Near the solution a Newton step gains less than a distance resolves.
  plan.tolerance_u2 = crevice ? 4 * this->slack_ * this->q_.norm() : 0.0;
  // At the end of an edge a ball cannot go on by rolling: a slide leaves the edge.
  plan.worthwhile = first.feasible && second.feasible && second.y.norm() > 4 * this->slack_ &&
                    (second.y - this->q_).squaredNorm() < this->q_.squaredNorm() + plan.tolerance_u2;
  plan.sets = this->sets_;
  plan.first = first.y;
  plan.second = second.y;
  return plan;
}

template class RollPlanner<Scene>;
template class RollPlanner<MovingScene>;

} // namespace palpate
