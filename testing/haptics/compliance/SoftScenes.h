// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "SoftPads.h"
#include "haptics/compliance/servo/SoftTick.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate::test
{

/// A pad with its surface in a scene, felt by a ball, all in metres.
struct SoftScene
{
  explicit SoftScene(SoftPad padded, double radius_u = 0.005, double wholeWidth = 0.4)
    : pad(std::move(padded)), scene(1, { surfaceOf(pad) }), room(std::make_unique<SoftScratch>())
  {
    this->plan.radius_u = radius_u;
    this->snapshot = std::make_shared<ComplianceSnapshot>(*this->pad.snapshot(radius_u, wholeWidth));
    this->touch = { 0, this->snapshot.get() };
  }

  static Surface surfaceOf(const SoftPad& pad)
  {
    Surface surface;
    surface.tree = std::make_shared<const SurfaceTree>(TriangleMesh{ pad.surface.rest_W, pad.surface.triangles });
    return surface;
  }

  SoftResult move(const Vec3& p_W)
  {
    return moveOnSoft(this->scene, this->plan, std::span(&this->touch, 1), p_W, this->state, *this->room);
  }

  void scaleCompliance(double factor)
  {
    this->snapshot->compliance *= factor;
    this->snapshot->springs.assign(this->snapshot->springs.size(), SubgridSpring{});
  }

  SoftPad pad;
  Scene scene;
  ContactPlan plan;
  std::shared_ptr<ComplianceSnapshot> snapshot;
  SoftSurfaceRef touch;
  SoftState state;
  std::unique_ptr<SoftScratch> room;
};

/// Presses into the middle and slides along, 1 kHz: .1 m/s.
inline Vec3 wayOver(int tick)
{
  const double s = 1e-4 * tick;
  return Vec3(0.03 + std::min(s, 0.03), 0.045 + 0.2 * std::min(s, 0.03), 0.056 - std::min(0.4 * s, 0.009));
}

/// Height of bumps of 4 mm, up to 31 degrees steep.
inline double bumpAt(const Vec3& p)
{
  return 0.05 + 0.004 * std::sin(150.0 * p.x()) * std::sin(150.0 * p.y());
}

inline SoftPad bumpyPad()
{
  return SoftPad(10, 2.0, ElementKind::Linear,
    [](SoftBodyInput& input)
    {
      for (Vec3& p : input.mesh.vertices_W)
      {
        p.z() *= bumpAt(p) / 0.05;
      }
    });
}

} // namespace palpate::test
