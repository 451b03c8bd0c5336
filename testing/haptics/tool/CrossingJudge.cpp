// SPDX-License-Identifier: GPL-3.0-or-later
#include "CrossingJudge.h"

#include "testing/support/ExactTriangles.h"

namespace palpate::test
{
namespace
{

Eigen::AlignedBox3d boundsOf(const TriangleMesh& mesh, std::uint32_t t)
{
  Eigen::AlignedBox3d bounds;
  for (const std::uint32_t v : mesh.triangles[t])
  {
    bounds.extend(mesh.vertices_W[v]);
  }
  return bounds;
}

} // namespace

CrossingJudge::CrossingJudge(const BoxedMesh& tool_B, const BoxedMesh& scene_W, int inside)
  : tool_B_(tool_B.mesh()), scene_W_(scene_W.mesh()), inside_(inside)
{
  for (std::uint32_t t = 0; t < this->scene_W_.triangles.size(); ++t)
  {
    this->sceneBoxes_.push_back(boundsOf(this->scene_W_, t));
  }
}

void CrossingJudge::step(const ScrewStep& step, double share)
{
  if (this->steps_++ % this->every_ != 0)
  {
    return;
  }
  const double angle = step.w_W.norm();
  const Vec3 axis = angle > 0.0 ? Vec3(step.w_W / angle) : Vec3(Vec3::UnitZ());
  for (int i = 1; i <= this->inside_ + 1; ++i)
  {
    const double s = share * i / (this->inside_ + 1);
    const Mat3 turn = Eigen::AngleAxisd(s * angle, axis).toRotationMatrix() * step.from_W.q.toRotationMatrix();
    this->found_ += this->crossings(step.from_W.p + s * step.v_W, turn);
    ++this->judged_;
  }
}

std::vector<std::uint32_t> CrossingJudge::near(const Eigen::AlignedBox3d& bounds) const
{
  std::vector<std::uint32_t> near;
  for (std::uint32_t t = 0; t < this->sceneBoxes_.size(); ++t)
  {
    if (this->sceneBoxes_[t].intersects(bounds))
    {
      near.push_back(t);
    }
  }
  return near;
}

std::size_t CrossingJudge::crossings(const Vec3& centre_W, const Mat3& turn) const
{
  TriangleMesh tool_W = this->tool_B_;
  Eigen::AlignedBox3d bounds;
  for (Vec3& v : tool_W.vertices_W)
  {
    v = turn * v + centre_W;
    bounds.extend(v);
  }
  const std::vector<std::uint32_t> near = this->near(bounds);
  std::size_t count = 0;
  for (std::uint32_t a = 0; a < tool_W.triangles.size(); ++a)
  {
    const Eigen::AlignedBox3d box = boundsOf(tool_W, a);
    for (const std::uint32_t b : near)
    {
      if (box.intersects(this->sceneBoxes_[b]) &&
          CGAL::do_intersect(triangleOf<Filtered>(tool_W, a), triangleOf<Filtered>(this->scene_W_, b)))
      {
        ++count;
      }
    }
  }
  return count;
}

} // namespace palpate::test
