// SPDX-License-Identifier: GPL-3.0-or-later
// What the mouse in a view asks of a session: where a way meets what is touched, and how deep it presses.
#include "haptics/contact/planes/FeatureGeometry.h"
#include "haptics/contact/sweep/Sweep.h"
#include "vtkHapticSessionInternals.h"

namespace
{
using palpate::Vec3;

/// What a person waits for once, not what a tick may cost.
constexpr std::uint32_t nodesToVisit = 1u << 24;

/// The plane that holds the ball where it was stopped; against its way where a point met an edge or a corner.
template<class SceneView>
Vec3 NormalAt(const SceneView& scene, const palpate::SweepHit& hit, const palpate::SweepQuery& query, const Vec3& x_W)
{
  if (hit.feature.kind != palpate::FeatureKind::Face && query.radius_u == 0.0)
  {
    return (query.from_W - query.to_W).normalized();
  }
  const auto& surface = palpate::surfaceOf(scene, hit.feature.surface);
  return palpate::planeOf(surface, hit.feature, x_W, query.radius_u).n;
}

template<class SceneView>
bool Meets(const SceneView& scene, const palpate::SweepQuery& query, Vec3& x_W, Vec3& n_W)
{
  const palpate::SweepHit hit = palpate::sweepBall(scene, query, nodesToVisit);
  if (hit.hit)
  {
    x_W = query.from_W + hit.t * (query.to_W - query.from_W);
    n_W = NormalAt(scene, hit, query, x_W);
  }
  return hit.hit;
}
} // namespace

bool vtkHapticSession::PickSurface(
  const double from_W[3], const double to_W[3], double ball_W[3], double normal_W[3]) const
{
  const Internals& impl = *this->Impl;
  if (!impl.Scene.built().scene || impl.Scene.built().scene->empty())
  {
    return false;
  }
  const palpate::Scene& scene = *impl.Scene.built().scene;
  palpate::SweepQuery query;
  query.from_W = Vec3(from_W);
  query.to_W = Vec3(to_W);
  query.radius_u = impl.Asked.touch(impl.Scene.built()).plan.radius_u;
  query.resolution.include(query.from_W);
  query.resolution.include(query.to_W);
  query.resolution.include(Vec3::Constant(query.radius_u + scene.mostCoat_u()));
  const double share = impl.State.sceneRevision == scene.revision() ? impl.State.sceneShare : 0.0;
  Vec3 x_W;
  Vec3 n_W;
  if (!(scene.moves() ? Meets(palpate::MovingScene(scene, share), query, x_W, n_W) : Meets(scene, query, x_W, n_W)))
  {
    return false;
  }
  Eigen::Map<Vec3>{ ball_W } = x_W;
  Eigen::Map<Vec3>{ normal_W } = n_W;
  return true;
}

void vtkHapticSession::SetEye(const double p_W[3])
{
  this->Impl->Eye_W = Vec3(p_W);
}

void vtkHapticSession::SetPressDepth(double depth_m)
{
  if (this->Allows("PressDepth", { depth_m }))
  {
    this->Impl->PressDepth_m = depth_m;
    this->Modified();
  }
}

double vtkHapticSession::GetPressDepth() const
{
  return this->Impl->PressDepth_m;
}

bool vtkHapticSession::GetFollowsMouse() const
{
  return this->Impl->DeviceNameNow() == "mouse";
}
