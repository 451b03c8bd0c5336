// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/methods/StaticFrameProxy.h"

#include "testing/lab/methods/Planes.h"

namespace palpate::lab
{

StaticFrameProxy::StaticFrameProxy(const std::vector<TriangleMesh>& meshes, const Vec3& start_W) : x_W_(start_W)
{
  for (const TriangleMesh& mesh : meshes)
  {
    this->faces_.push_back(std::make_unique<const FaceTree>(mesh));
  }
}

Vec3 StaticFrameProxy::tick(const std::vector<Pose>& poses_WS, const Vec3& p_W)
{
  const Vec3 from_W = this->x_W_;
  double nearest_u = (p_W - from_W).norm();
  this->x_W_ = p_W;
  for (std::size_t i = 0; i < this->faces_.size(); ++i)
  {
    const Pose& pose = poses_WS[i];
    const Quat toSurface = pose.q.conjugate();
    const Vec3 from_S = toSurface * (from_W - pose.p), p_S = toSurface * (p_W - pose.p);
    const auto hit = this->faces_[i]->firstHit(from_S, p_S);
    if (hit && (hit->point_W - from_S).norm() <= nearest_u)
    {
      nearest_u = (hit->point_W - from_S).norm();
      this->x_W_ = pose.p + pose.q * nearestInFront({ planeTowards(*hit, from_S, gap_u) }, p_S);
    }
  }
  return this->x_W_;
}

} // namespace palpate::lab
