// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/LongRun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include "testing/support/Meshes.h"
#include "testing/support/QpOracle.h"

namespace palpate::test
{
namespace
{

constexpr std::uint64_t ticksPerRound = 500;
constexpr int stillTicks = 40;
constexpr int pullTicks = 20;
constexpr int placeAttempts = 300;
constexpr int waysTried = 12;
/// Of the size: positions are sums and products of coordinates, normals of slivers lose five digits more.
constexpr double clearanceShare = 1e-8;
/// Of the radius: a nearer triangle counts as touched, and its normal is known to that much.
constexpr double touchShare = 1e-6;
/// Of the distance to the hand: touched planes at an angle of 1e-3 rad magnify the error of a normal a thousandfold.
constexpr double restShare = 2e-3;

} // namespace

JudgedMesh::JudgedMesh(TriangleMesh clean) : mesh(std::move(clean)), nearest(this->mesh), path(this->mesh, 0.0) {}

bool RunFigures::clean() const noexcept
{
  return TickFigures::clean() && this->fallen + this->stuck + this->restless + this->notAtRest == 0;
}

RunFigures& RunFigures::operator+=(const RunFigures& more)
{
  TickFigures::operator+=(more);
  this->fallen += more.fallen;
  this->stuck += more.stuck;
  this->restless += more.restless;
  this->notAtRest += more.notAtRest;
  this->touching += more.touching;
  this->pulls += more.pulls;
  this->rests += more.rests;
  this->infeasible += more.infeasible;
  this->work += more.work;
  this->mostWork = std::max(this->mostWork, more.mostWork);
  this->spent += more.spent;
  this->created += more.created;
  return *this;
}

std::string RunFigures::text() const
{
  std::ostringstream out;
  const double mean = this->ticks > 0 ? static_cast<double>(this->work) / static_cast<double>(this->ticks) : 0.0;
  out << TickFigures::text() << "; " << this->touching << " touching, fallen " << this->fallen << ", stuck "
      << this->stuck << " of " << this->pulls << ", restless " << this->restless << " and not at rest "
      << this->notAtRest << " of " << this->rests << ", infeasible " << this->infeasible << "; work " << mean
      << " a tick, at most " << this->mostWork << "; energy created " << this->created << " of " << this->spent;
  return out.str();
}

RunTask taskOn(const BadMesh& made, const JudgedMesh& touched, const JudgedMesh& shape)
{
  RunTask task;
  task.scene = sceneOf(made.bad);
  task.touched = &touched;
  task.shape = &shape;
  task.gap_u = made.gap_u;
  task.size_u = made.size_u;
  return task;
}

LongRun::LongRun(const RunTask& task)
  : task_(task), judge_(task.touched->path, task.plan, task.size_u),
    wayChecker_(task.touched->path, task.plan.radius_u, clearanceShare * task.size_u), random_(task.seed),
    depth_u_(std::max(0.03 * task.size_u, 1.5 * task.plan.radius_u)),
    hand_(task.shape != nullptr ? task.shape->mesh : task.touched->mesh, this->depth_u_, task.seed + 1)
{
  const double half_u = task.gap_u / 2;
  if (task.shape != nullptr && half_u < task.plan.radius_u + (task.gap_u == 0.0))
  {
    this->shapeChecker_.emplace(
      task.shape->path, std::max(0.0, task.plan.radius_u - half_u), clearanceShare * task.size_u);
  }
  this->placed_ = this->place();
}

/// A random place beside a face, on the wanted side of it and free of everything else.
bool LongRun::place()
{
  const JudgedMesh& shape = this->task_.shape != nullptr ? *this->task_.shape : *this->task_.touched;
  const TriangleMesh& mesh = shape.mesh;
  for (int attempt = 0; attempt < placeAttempts; ++attempt)
  {
    const auto [a, b, c] = mesh.triangles[this->random_.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
    const Vec3 &va = mesh.vertices_W[a], &vb = mesh.vertices_W[b], &vc = mesh.vertices_W[c];
    const double away_u = 1.2 * this->task_.plan.radius_u + 1e-4 * this->task_.size_u;
    const Vec3 normal = (vb - va).cross(vc - va).normalized() * (this->task_.inside ? -1.0 : 1.0);
    const Vec3 x_W = (va + vb + vc) / 3 + away_u * normal;
    const double least_u = 1.1 * this->task_.plan.radius_u + 0.5e-4 * this->task_.size_u;
    if (shape.nearest.distance_u(x_W) > (1 - 1e-6) * away_u && this->task_.touched->nearest.distance_u(x_W) > least_u)
    {
      this->tick(x_W);
      return this->state_.x_W == x_W;
    }
  }
  return false;
}

void LongRun::segment(const Vec3& from_W, const Vec3& to_W) noexcept
{
  this->judge_.segment(from_W, to_W);
  if (this->shapeChecker_)
  {
    this->shapeChecker_->segment(from_W, to_W);
  }
}

void LongRun::note(std::uint64_t& count, const std::string& what)
{
  ++count;
  if (this->figures_.first.empty())
  {
    this->figures_.first = "tick " + std::to_string(this->judge_.figures().ticks) + ": " + what;
  }
}

RunFigures LongRun::figures() const
{
  RunFigures all = this->figures_;
  static_cast<TickFigures&>(all) += this->judge_.figures();
  return all;
}

void LongRun::run(std::uint64_t ticks)
{
  const std::uint64_t end = this->judge_.figures().ticks + ticks;
  while (this->judge_.figures().ticks < end)
  {
    for (std::uint64_t i = 0; i < ticksPerRound && this->judge_.figures().ticks < end; ++i)
    {
      this->tick(this->hand_.next());
    }
    this->keepStill();
    this->pullAway();
    this->hand_.moveTo(this->p_W_);
  }
}

ContactResult LongRun::tick(const Vec3& p_W)
{
  const Vec3 before_W = this->state_.x_W;
  const bool moves = this->state_.placed;
  const ContactResult result = moveGodObject(*this->task_.scene, this->task_.plan, p_W, this->state_, this);
  this->figures_.touching += result.contacts > 0;
  this->figures_.infeasible += result.infeasible;
  this->figures_.work += result.work;
  this->figures_.mostWork = std::max<std::uint64_t>(this->figures_.mostWork, result.work);
  if (moves)
  {
    this->judge_.judge(before_W, p_W, result, this->state_.x_W);
    this->judgeEnergy(before_W, p_W);
    this->judgeShape(before_W);
  }
  this->p_W_ = p_W;
  return result;
}

/// With the hand at rest the ball's own motion may only slacken the spring.
void LongRun::judgeEnergy(const Vec3& before_W, const Vec3& p_W)
{
  const double unit = 1.0 / (this->depth_u_ * this->depth_u_);
  const double old = (before_W - this->p_W_).squaredNorm(), stretched = (before_W - p_W).squaredNorm();
  this->figures_.spent += 0.5 * unit * std::max(0.0, stretched - old);
  this->figures_.created += 0.5 * unit * std::max(0.0, (this->state_.x_W - p_W).squaredNorm() - stretched);
}

void LongRun::judgeShape(const Vec3& before_W)
{
  if (!this->shapeChecker_)
  {
    return;
  }
  if (const std::string found = this->shapeChecker_->finding(before_W); !found.empty())
  {
    this->note(this->figures_.fallen, "clean shape: " + found);
  }
}

void LongRun::keepStill()
{
  ContactResult result;
  Vec3 before_W = this->state_.x_W;
  for (int i = 0; i < stillTicks; ++i)
  {
    before_W = this->state_.x_W;
    result = this->tick(this->p_W_);
  }
  if (result.contacts == 0 && this->state_.x_W == this->p_W_)
  {
    return;
  }
  ++this->figures_.rests;
  if ((this->state_.x_W - before_W).norm() > clearanceShare * this->task_.size_u)
  {
    this->note(this->figures_.restless, "it moves while the hand keeps still");
    return;
  }
  if (this->task_.plan.friction.none())
  {
    this->judgeRest(result);
  }
}

void LongRun::judgeRest(const ContactResult& result)
{
  const bool couldGoOn = this->task_.plan.radius_u > 0.0 ? this->ballCouldGoOn() : this->pointCouldGoOn();
  if (couldGoOn)
  {
    std::ostringstream what;
    what.precision(17);
    what << "at rest at (" << this->state_.x_W.transpose() << ") with the hand at (" << this->p_W_.transpose()
         << ") it could go on; capped " << result.capped << ", contacts " << result.contacts;
    this->note(this->figures_.notAtRest, what.str());
  }
}

/// The hand must lie in the cone of the touched features' normals: then no displacement under them leads nearer to it.
bool LongRun::ballCouldGoOn() const
{
  const double r = this->task_.plan.radius_u;
  const Vec3 pull = this->p_W_ - this->state_.x_W;
  if (pull.norm() <= clearanceShare * this->task_.size_u)
  {
    return false;
  }
  std::vector<PlaneRow> rows;
  for (const Vec3& nearest_W : this->task_.touched->nearest.within(this->state_.x_W, (1 + touchShare) * r))
  {
    const Vec3 normal = (this->state_.x_W - nearest_W).normalized();
    const auto same = [&](const PlaneRow& row) { return (row.n - normal).norm() <= touchShare; };
    if (std::none_of(rows.begin(), rows.end(), same))
    {
      rows.push_back({ normal, 0.0 });
    }
  }
  const Vec3 unit = pull / pull.norm();
  return projectExactly(rows, unit).y.norm() > restShare;
}

/// A point at a corner has no normals; short displacements towards the hand are tried instead, and none may be free.
bool LongRun::pointCouldGoOn()
{
  const Vec3 pull = this->p_W_ - this->state_.x_W;
  const double step_u = 1e-6 * this->task_.size_u;
  if (pull.norm() < 10 * step_u)
  {
    return false;
  }
  for (int i = 0; i < waysTried; ++i)
  {
    Vec3 way = this->random_.direction();
    way *= way.dot(pull) < 0 ? -1.0 : 1.0;
    if (way.dot(pull) > 0.1 * pull.norm() && this->freeWay(this->state_.x_W + step_u * way))
    {
      return true;
    }
  }
  return false;
}

bool LongRun::freeWay(const Vec3& to_W)
{
  this->wayChecker_.segment(this->state_.x_W, to_W);
  return this->wayChecker_.finding(this->state_.x_W).empty();
}

void LongRun::pullAway()
{
  for (int i = 0; i < waysTried; ++i)
  {
    const Vec3 to_W =
      this->state_.x_W + this->random_.uniform(0.01, 0.1) * this->task_.size_u * this->random_.direction();
    if (!this->freeWay(to_W))
    {
      continue;
    }
    ++this->figures_.pulls;
    for (int k = 0; k < pullTicks && this->state_.x_W != to_W; ++k)
    {
      this->tick(to_W);
    }
    if ((this->state_.x_W - to_W).norm() > clearanceShare * this->task_.size_u)
    {
      std::ostringstream what;
      what.precision(17);
      what << "the way to (" << to_W.transpose() << ") is free and the ball stays at (" << this->state_.x_W.transpose()
           << ")";
      this->note(this->figures_.stuck, what.str());
    }
    return;
  }
}

} // namespace palpate::test
