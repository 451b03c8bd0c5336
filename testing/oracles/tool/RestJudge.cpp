// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/oracles/tool/RestJudge.h"

#include <cmath>
#include <utility>

#include "testing/support/ExactTriangles.h"

namespace palpate::test
{
namespace
{

Eigen::AlignedBox3d boxOf(const TriangleMesh& mesh, std::uint32_t t)
{
  Eigen::AlignedBox3d box;
  for (const std::uint32_t v : mesh.triangles[t])
  {
    box.extend(mesh.vertices_W[v]);
  }
  return box;
}

} // namespace

RestJudge::RestJudge(TriangleMesh tool_B, TriangleMesh scene_W, double characteristic_u)
  : tool_B_(std::move(tool_B)), scene_W_(std::move(scene_W)), characteristic_u_(characteristic_u)
{
  for (std::uint32_t t = 0; t < this->scene_W_.triangles.size(); ++t)
  {
    this->sceneBoxes_.push_back(boxOf(this->scene_W_, t));
  }
  Eigen::AlignedBox3d bounds;
  for (const Vec3& v : this->tool_B_.vertices_W)
  {
    bounds.extend(v);
  }
  this->size_u_ = bounds.diagonal().norm();
}

bool RestJudge::meets(const Pose& pose_W) const
{
  TriangleMesh tool_W = this->tool_B_;
  Eigen::AlignedBox3d bounds;
  for (Vec3& v : tool_W.vertices_W)
  {
    v = pose_W.q * v + pose_W.p;
    bounds.extend(v);
  }
  for (std::uint32_t b = 0; b < this->scene_W_.triangles.size(); ++b)
  {
    for (std::uint32_t a = 0; this->sceneBoxes_[b].intersects(bounds) && a < tool_W.triangles.size(); ++a)
    {
      if (boxOf(tool_W, a).intersects(this->sceneBoxes_[b]) &&
          CGAL::do_intersect(triangleOf<Filtered>(tool_W, a), triangleOf<Filtered>(this->scene_W_, b)))
      {
        return true;
      }
    }
  }
  return false;
}

RestJudge::Motion RestJudge::between(const Pose& from_W, const Pose& to_W) const
{
  const Eigen::AngleAxisd turn(to_W.q * from_W.q.conjugate());
  Motion motion;
  motion << to_W.p - from_W.p, this->characteristic_u_ * turn.angle() * turn.axis();
  return motion;
}

double RestJudge::distance_u(const Pose& from_W, const Pose& to_W) const
{
  return this->between(from_W, to_W).norm();
}

Pose RestJudge::moved(const Pose& pose_W, const Motion& motion) const
{
  const Vec3 turn_rad = motion.tail<3>() / this->characteristic_u_;
  const double angle_rad = turn_rad.norm();
  const Eigen::AngleAxisd turn(angle_rad, angle_rad > 0.0 ? Vec3(turn_rad / angle_rad) : Vec3(Vec3::UnitZ()));
  return { pose_W.p + motion.head<3>(), (Quat(turn) * pose_W.q).normalized() };
}

/// Looked at each hundredth of the tool's size, and at the end first.
bool RestJudge::isFree(const Pose& pose_W, const Motion& motion) const
{
  const int looks = 2 + static_cast<int>(motion.norm() / (0.01 * this->size_u_));
  for (int i = looks; i > 0; --i)
  {
    if (this->meets(this->moved(pose_W, i / static_cast<double>(looks) * motion)))
    {
      return false;
    }
  }
  return true;
}

double RestJudge::gain_u(const Pose& pose_W, const Pose& hand_W, int trials, Random& random) const
{
  // Of the tool's size. A longer motion may pass over an obstacle that the tool rests at, between two looks, into
  // another place of rest.
  constexpr double longest = 0.002, shortest = 1e-5;
  constexpr double grows = 1.5, shrinks = 0.93;
  Pose at_W = pose_W;
  double length = longest;
  const double before_u = this->distance_u(pose_W, hand_W);
  double left_u = before_u;
  for (int i = 0; i < trials; ++i)
  {
    Motion aside;
    aside << random.direction() * random.uniform(), random.direction() * random.uniform();
    const Motion wish = this->between(at_W, hand_W);
    const Motion way = wish.normalized() * random.uniform() + aside;
    const Motion motion = std::min(length * this->size_u_, wish.norm()) * way.normalized();
    const Pose next_W = this->moved(at_W, motion);
    const double next_u = this->distance_u(next_W, hand_W);
    const bool better = next_u < left_u && this->isFree(at_W, motion);
    at_W = better ? next_W : at_W;
    left_u = better ? next_u : left_u;
    length = std::min(longest, std::max(shortest, length * (better ? grows : shrinks)));
  }
  return before_u - left_u;
}

} // namespace palpate::test
