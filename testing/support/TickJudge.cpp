// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/TickJudge.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "testing/support/FreeWay.h"
#include "testing/support/FrictionCone.h"

namespace palpate::test
{
namespace
{

/// Of the size: allowed shortfall of a ball's distance, for positions are sums and products of coordinates, and normals
/// of slivers lose five digits more. Of a small ball no more than a thousandth.
constexpr double clearanceShare = 1e-8;
constexpr double clearanceOfRadius = 1e-3;
/// Of the largest coordinate: a point that stays nearer to the device is there, for it stands off its faces by a few
/// roundings of the coordinates.
constexpr double thereShare = 1e-12;
/// Of the radius: a ball that stays nearer to the device is there. Where two faces meet at 1e-4 rad it then goes deeper
/// than allowed (FreeWay.h).
constexpr double thereOfRadius = 1e-4;
/// Of the size and of the radius: a nearer triangle is touched.
constexpr double touchShare = 1e-8;
constexpr double touchOfRadius = 1e-6;
/// Of the pull: rounding of a friction cone.
constexpr double coneShare = 1e-6;

double clearance(const ContactPlan& plan, double size_u)
{
  return std::min(clearanceShare * size_u, clearanceOfRadius * plan.radius_u);
}

} // namespace

bool TickFigures::clean() const noexcept
{
  return this->glued + this->through + this->adrift + this->beyond + this->untrue + this->notFinite + this->notPlaced ==
         0;
}

TickFigures& TickFigures::operator+=(const TickFigures& more)
{
  this->glued += more.glued;
  this->through += more.through;
  this->adrift += more.adrift;
  this->beyond += more.beyond;
  this->untrue += more.untrue;
  this->notFinite += more.notFinite;
  this->notPlaced += more.notPlaced;
  this->ticks += more.ticks;
  this->held += more.held;
  this->capped += more.capped;
  this->overBudget += more.overBudget;
  this->mostBeyond = std::max(this->mostBeyond, more.mostBeyond);
  this->first = this->first.empty() ? more.first : this->first;
  return *this;
}

std::string TickFigures::text() const
{
  std::ostringstream out;
  out << this->ticks << " ticks, " << this->held << " held; glued " << this->glued << ", through " << this->through
      << ", adrift " << this->adrift << ", beyond friction " << this->beyond << " (at most " << this->mostBeyond
      << " of the pull), untrue " << this->untrue << ", not finite " << this->notFinite << ", not placed "
      << this->notPlaced << "; capped " << this->capped << ", over budget " << this->overBudget;
  return out.str();
}

TickJudge::TickJudge(const PathChecker& surface, const ContactPlan& plan, double size_u)
  : plan_(plan), size_u_(size_u), grid_(surface.grid()), path_(surface, plan.radius_u, clearance(plan, size_u))
{
}

void TickJudge::segment(const Vec3& from_W, const Vec3& to_W) noexcept
{
  this->path_.segment(from_W, to_W);
  this->pathEnd_W_ = to_W;
}

void TickJudge::judge(const Vec3& before_W, const Vec3& p_W, const ContactResult& result, const Vec3& after_W)
{
  ++this->figures_.ticks;
  this->figures_.held += after_W != p_W;
  this->figures_.capped += result.capped;
  this->figures_.overBudget += result.overBudget;
  if (!after_W.allFinite() || !result.pull_W.allFinite())
  {
    this->note(this->figures_.notFinite, "the god-object is nowhere", p_W, after_W);
    return;
  }
  if (result.proxy_W != after_W || result.pull_W != after_W - p_W)
  {
    this->note(this->figures_.untrue, "the pull is not the way from the device to the god-object", p_W, after_W);
  }
  this->judgePath(before_W, after_W);
  if (after_W != p_W && !result.capped && !result.overBudget)
  {
    this->judgeRest(p_W, after_W);
  }
}

void TickJudge::judgePath(const Vec3& before_W, const Vec3& after_W)
{
  std::string found = this->path_.finding(before_W);
  if (found.empty() && this->pathEnd_W_ != after_W && before_W != after_W)
  {
    found = "the path ends elsewhere";
  }
  if (!found.empty())
  {
    this->note(this->figures_.through, found, before_W, after_W);
  }
  this->pathEnd_W_ = after_W;
}

void TickJudge::judgeRest(const Vec3& p_W, const Vec3& after_W)
{
  if (this->couldCome(p_W, after_W))
  {
    this->note(this->figures_.glued, "the way to the device is free", p_W, after_W);
    return;
  }
  this->judgeHold(p_W, after_W);
}

bool TickJudge::couldCome(const Vec3& p_W, const Vec3& after_W) const
{
  const double way_u = (p_W - after_W).norm(), r = this->plan_.radius_u;
  if (r > 0.0)
  {
    return way_u > std::max(thereOfRadius * r, clearanceShare * this->size_u_) &&
           wayIsFree(*this->grid_, after_W, p_W, r);
  }
  const double largest = std::max(p_W.cwiseAbs().maxCoeff(), after_W.cwiseAbs().maxCoeff());
  return way_u > thereShare * largest && wayIsFree(*this->grid_, after_W, p_W);
}

void TickJudge::judgeHold(const Vec3& p_W, const Vec3& after_W)
{
  const double r = this->plan_.radius_u, reach_u = std::max(touchShare * this->size_u_, touchOfRadius * r);
  const Vec3 pull_W = p_W - after_W;
  if (pull_W.norm() <= 2 * reach_u)
  {
    return;
  }
  if (!touches(*this->grid_, after_W, r + reach_u))
  {
    this->note(this->figures_.adrift, "it touches nothing", p_W, after_W);
    return;
  }
  if (this->plan_.friction.none())
  {
    return;
  }
  const std::vector<Vec3> normals = touchedNormals(*this->grid_, after_W, r, reach_u);
  const double beyond = beyondFriction(normals, pull_W, this->plan_.friction.statical) / pull_W.norm();
  if (beyond > coneShare)
  {
    this->figures_.mostBeyond = std::max(this->figures_.mostBeyond, beyond);
    this->note(this->figures_.beyond, "it is drawn beyond friction", p_W, after_W);
  }
}

void TickJudge::note(std::uint64_t& count, const std::string& what, const Vec3& p_W, const Vec3& after_W)
{
  ++count;
  if (this->figures_.first.empty())
  {
    std::ostringstream out;
    out.precision(17);
    out << "tick " << this->figures_.ticks << ", radius " << this->plan_.radius_u << ", friction "
        << this->plan_.friction.statical << ": " << what << " (device " << p_W.transpose() << ", god-object "
        << after_W.transpose() << ")";
    this->figures_.first = out.str();
  }
}

} // namespace palpate::test
