// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "SoftPads.h"
#include "haptics/compliance/servo/SoftTick.h"
#include "haptics/geometry/scene/Scene.h"
#include "testing/oracles/axisymmetric/BallOnLayer.h"

namespace palpate::test
{

/// Places from 0 on, `edge` apart up to `even`, then further and further apart until `end`.
inline std::vector<double> gradedPlaces(double edge, double even, double end)
{
  std::vector<double> places{ 0.0 };
  for (double step = edge; places.back() < end - 1e-12;)
  {
    step = places.back() < even - 1e-12 ? edge : 1.4 * step;
    const double rest = end - places.back();
    places.push_back(rest < 1.5 * step ? end : places.back() + step);
  }
  return places;
}

/// Places through a layer: equally far apart where all of it is even, so that none of its cells is higher than an edge
/// by more than a twentieth.
inline std::vector<double> placesThrough(double edge, double even, double thickness)
{
  if (even < thickness)
  {
    return gradedPlaces(edge, even, thickness);
  }
  const int cells = std::max(1, static_cast<int>(std::ceil(thickness / edge - 0.05)));
  std::vector<double> places;
  for (int i = 0; i <= cells; ++i)
  {
    places.push_back(thickness * i / cells);
  }
  return places;
}

/// A layer, fixed below, whose edges are even around the middle of its top. The layer is so wide that its free sides,
/// four thicknesses away, take less than .1 % of a force (at 2.5 thicknesses .3 %).
inline SoftBodyInput layerOf(const oracle::Layer& layer, double edge, double even)
{
  const double h = layer.thickness_m;
  const std::vector<double> aside = gradedPlaces(edge, even, std::max(4.0 * h, 4.0 * even));
  const std::vector<double> down = placesThrough(edge, even, h);
  const int half = static_cast<int>(aside.size()) - 1;
  const int deep = static_cast<int>(down.size()) - 1;
  SoftBodyInput input;
  input.mesh = blockOf({ 2 * half, 2 * half, deep }, Vec3(2 * half, 2 * half, deep));
  const auto placeOf = [&](double cell)
  {
    const int i = static_cast<int>(std::lround(cell)) - half;
    return (i < 0 ? -1.0 : 1.0) * aside[static_cast<std::size_t>(std::abs(i))];
  };
  for (Vec3& p : input.mesh.vertices_W)
  {
    p = Vec3(placeOf(p.x()), placeOf(p.y()), -down[static_cast<std::size_t>(deep - std::lround(p.z()))]);
  }
  input.fixed = fixedWhere(input.mesh, [h](const Vec3& p) { return p.z() <= -h + 1e-12; });
  input.young_Pa = { layer.young_Pa };
  input.poisson = layer.poisson;
  input.model = ElasticModel::Linear;
  input.mostBytes = std::size_t{ 16 } << 30;
  return input;
}

/// Presses a ball into a body's top, by turns of a tick and a snapshot as at rate 0.
class Presser
{
public:
  Presser(const SoftBodyInput& input, double ball_m) : room_(std::make_unique<SoftScratch>())
  {
    SoftBodyResult made = makeSoftBody(input);
    EXPECT_TRUE(made.body) << made.refusal;
    this->body_ = std::move(made.body);
    this->surface_ = makeSoftSurface(*this->body_, made.checked.mesh);
    Surface surface;
    surface.tree = std::make_shared<const SurfaceTree>(TriangleMesh{ this->surface_.rest_W, this->surface_.triangles });
    this->scene_ = std::make_unique<Scene>(1, std::vector<Surface>{ surface });
    this->maker_ = std::make_unique<SnapshotMaker>(*this->body_, this->surface_);
    this->plan_.radius_u = ball_m;
    this->plan_.coupling_N_per_m = 1e4;
    this->plan_.friction = { 5.0, 5.0 };
    this->request_.radius_u = ball_m;
    this->request_.period_s = 0.001;
  }

  /// The force on a ball so deep below a place.
  double press(double depth_m, const Vec3& at_W = Vec3::Zero())
  {
    this->state_ = {};
    (void)this->tick(at_W + Vec3(0.0, 0.0, 1.5 * this->plan_.radius_u));
    Vec3 target_W = at_W + Vec3(0.0, 0.0, this->plan_.radius_u - depth_m);
    SoftResult found;
    for (int turn = 0; turn < 12; ++turn)
    {
      found = this->tick(target_W - found.force_N / this->plan_.coupling_N_per_m);
    }
    EXPECT_NEAR(found.proxy_W.z(), target_W.z(), 1e-4 * depth_m);
    this->pressed_ = found;
    return found.force_N.z();
  }

  /// How far a pressed ball goes along the surface under a force along it [m/N].
  double givesAlong(double aside_m)
  {
    const Vec3 device_W = this->pressed_.proxy_W - this->pressed_.force_N / this->plan_.coupling_N_per_m;
    const SoftResult found = this->tick(device_W + Vec3(aside_m, 0.0, 0.0));
    return (found.proxy_W.x() - this->pressed_.proxy_W.x()) / (this->pressed_.force_N.x() - found.force_N.x());
  }

private:
  SoftResult tick(const Vec3& device_W)
  {
    this->request_.ball_W = this->state_.core.placed ? this->state_.core.x_W : device_W;
    this->request_.forceAt.clear();
    this->request_.force_N.clear();
    for (int c = 0; c < this->state_.count; ++c)
    {
      this->request_.forceAt.push_back(this->state_.contacts[c].point.at);
      this->request_.force_N.push_back(-this->state_.contacts[c].force_N);
    }
    const auto before = std::exchange(this->snapshot_, this->maker_->make(this->request_, 1));
    this->touch_ = { 0, this->snapshot_.get() };
    changeSnapshots(std::span(&this->touch_, 1), this->state_);
    this->state_.offset_W.setZero(); // as when the offset of a change has faded
    return moveOnSoft(*this->scene_, this->plan_, std::span(&this->touch_, 1), device_W, this->state_, *this->room_);
  }

  std::unique_ptr<SoftBody> body_;
  SoftSurface surface_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<SnapshotMaker> maker_;
  std::unique_ptr<SoftScratch> room_;
  SnapshotRequest request_;
  ContactPlan plan_;
  std::shared_ptr<const ComplianceSnapshot> snapshot_;
  SoftSurfaceRef touch_;
  SoftState state_;
  SoftResult pressed_;
};

} // namespace palpate::test
