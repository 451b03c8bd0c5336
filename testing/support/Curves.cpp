// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "haptics/geometry/scene/SceneBuilder.h"

namespace palpate::test
{
namespace
{

double pointDistance(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

/// Calls visit(a, b, radius) for each segment.
template<class Visit>
void forEachSegment(const std::vector<Tubes>& tubes, Visit visit)
{
  for (const Tubes& t : tubes)
  {
    for (const auto& line : t.curves.lines)
    {
      for (std::size_t k = 1; k < line.size(); ++k)
      {
        visit(t.curves.points_W[line[k - 1]], t.curves.points_W[line[k]], t.radius_u);
      }
    }
  }
}

} // namespace

Tubes tubeThrough(const std::vector<Vec3>& points_W, double radius_u)
{
  Tubes tubes;
  tubes.radius_u = radius_u;
  tubes.curves.points_W = points_W;
  tubes.curves.lines.emplace_back();
  for (std::uint32_t i = 0; i < points_W.size(); ++i)
  {
    tubes.curves.lines[0].push_back(i);
  }
  return tubes;
}

Tubes helix(double coil_u, double pitch_u, int turns, int pieces, double radius_u)
{
  std::vector<Vec3> points_W;
  for (int i = 0; i <= turns * pieces; ++i)
  {
    const double turn = static_cast<double>(i) / pieces, angle_rad = 2 * std::numbers::pi * turn;
    points_W.emplace_back(coil_u * std::cos(angle_rad), coil_u * std::sin(angle_rad), pitch_u * turn);
  }
  return tubeThrough(points_W, radius_u);
}

Tubes wanderingTubes(int lines, int points, double half_u, double radius_u, Random& random)
{
  Tubes tubes;
  tubes.radius_u = radius_u;
  for (int line = 0; line < lines; ++line)
  {
    Vec3 at_W = random.inCube(half_u), ahead = random.direction();
    tubes.curves.lines.emplace_back();
    for (int i = 0; i < points; ++i)
    {
      tubes.curves.lines.back().push_back(static_cast<std::uint32_t>(tubes.curves.points_W.size()));
      tubes.curves.points_W.push_back(at_W);
      ahead = (ahead + 0.8 * random.direction()).normalized();
      at_W += random.uniform(0.1, 0.4) * half_u * ahead;
    }
  }
  return tubes;
}

std::shared_ptr<const Scene> sceneOf(const std::vector<Tubes>& tubes, const TriangleMesh& mesh)
{
  std::vector<SurfaceInput> inputs;
  for (const Tubes& t : tubes)
  {
    SurfaceInput input;
    input.name = "tubes " + std::to_string(inputs.size());
    input.mesh = std::make_shared<const TriangleMesh>(segmentsOf(t.curves));
    input.lineRadius_u = t.radius_u;
    inputs.push_back(std::move(input));
  }
  if (!mesh.triangles.empty())
  {
    inputs.push_back({ "mesh", std::make_shared<const TriangleMesh>(mesh), {} });
  }
  SceneBuildResult built = SceneBuilder().build(inputs);
  for (const SurfaceReport& report : built.reports)
  {
    if (!report.refusal.empty())
    {
      throw std::runtime_error(report.name + " refused: " + report.refusal);
    }
  }
  return built.scene;
}

double segmentDistance(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1)
{
  double least = std::min(std::min(pointDistance(a0, b0, b1), pointDistance(a1, b0, b1)),
    std::min(pointDistance(b0, a0, a1), pointDistance(b1, a0, a1)));
  const Vec3 u = a1 - a0, v = b1 - b0, normal = u.cross(v), w = b0 - a0;
  const double normal2 = normal.squaredNorm();
  if (normal2 > 0.0)
  {
    const double s = w.cross(v).dot(normal) / normal2, t = w.cross(u).dot(normal) / normal2;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0)
    {
      least = std::min(least, std::abs(w.dot(normal)) / std::sqrt(normal2));
    }
  }
  return least;
}

double clearance(const std::vector<Tubes>& tubes, const Vec3& p_W)
{
  double least = std::numeric_limits<double>::infinity();
  forEachSegment(tubes, [&](const Vec3& a, const Vec3& b, double radius_u)
    { least = std::min(least, pointDistance(p_W, a, b) - radius_u); });
  return least;
}

TubeHand::TubeHand(const std::vector<Tubes>& tubes, double half_u, double fastest_u, std::uint64_t seed)
  : tubes_(tubes), half_u_(half_u), fastest_u_(fastest_u), random_(seed), p_W_(this->random_.inCube(half_u)),
    goal_W_(this->p_W_)
{
}

void TubeHand::choose()
{
  const auto below = [this](std::size_t count) { return this->random_.below(static_cast<std::uint32_t>(count)); };
  if (this->rubs_ > 0)
  {
    const Tubes& tubes = this->tubes_[this->tube_];
    this->step_u_ = tubes.radius_u * std::pow(10.0, this->random_.uniform(-1.5, 0.5));
    const auto& line = tubes.curves.lines[this->line_];
    this->point_ = std::min(this->point_ + 1, line.size() - 1);
    this->rubs_ = this->point_ + 1 < line.size() ? this->rubs_ - 1 : 0;
    this->goal_W_ = tubes.curves.points_W[line[this->point_]] + this->random_.inCube(0.4 * tubes.radius_u);
    return;
  }
  this->step_u_ = this->fastest_u_ * std::pow(10.0, this->random_.uniform(-1.5, 0.0));
  this->goal_W_ = this->random_.inCube(this->half_u_);
  if (this->random_.uniform() < 0.7)
  {
    this->tube_ = below(this->tubes_.size());
    this->line_ = below(this->tubes_[this->tube_].curves.lines.size());
    this->point_ = below(this->tubes_[this->tube_].curves.lines[this->line_].size());
    this->goal_W_ =
      this->tubes_[this->tube_].curves.points_W[this->tubes_[this->tube_].curves.lines[this->line_][this->point_]];
    this->rubs_ = 3;
  }
}

Vec3 TubeHand::next()
{
  if ((this->goal_W_ - this->p_W_).norm() < 1e-9 * this->half_u_)
  {
    this->choose();
  }
  const Vec3 way_W = this->goal_W_ - this->p_W_;
  this->p_W_ += std::min(1.0, this->step_u_ / way_W.norm()) * way_W;
  return this->p_W_;
}

void TubeChecker::segment(const Vec3& from_W, const Vec3& to_W) noexcept
{
  this->pieces_.emplace_back(from_W, to_W);
}

double TubeChecker::leastClearance(const Vec3& start_W, const Vec3& end_W)
{
  double least = clearance(this->tubes_, end_W);
  Vec3 at_W = start_W;
  for (const auto& [from_W, to_W] : this->pieces_)
  {
    if (from_W != at_W)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    at_W = to_W;
    forEachSegment(this->tubes_, [&, from = from_W, to = to_W](const Vec3& a, const Vec3& b, double radius_u)
      { least = std::min(least, segmentDistance(from, to, a, b) - radius_u); });
  }
  this->pieces_.clear();
  return at_W == end_W ? least : std::numeric_limits<double>::quiet_NaN();
}

} // namespace palpate::test
