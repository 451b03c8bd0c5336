// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "SoftPads.h"
#include "haptics/compliance/servo/SoftTick.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate::test
{

/// A pad with its surface in a scene, felt by a ball, all in metres.
struct SoftScene
{
  explicit SoftScene(SoftPad padded, double radius_u = 0.005, double wholeWidth = 0.4)
    : pad(std::move(padded)), scene(1, { surfaceOf(pad) }), room(std::make_unique<SoftRoom>())
  {
    this->plan.radius_u = radius_u;
    this->packet = std::make_shared<CompliancePacket>(*this->pad.packet(radius_u, wholeWidth));
    this->touch = { 0, this->packet.get() };
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
    this->packet->compliance *= factor;
    this->packet->springs.assign(this->packet->springs.size(), SubgridSpring{});
  }

  SoftPad pad;
  Scene scene;
  ContactPlan plan;
  std::shared_ptr<CompliancePacket> packet;
  SoftTouch touch;
  SoftState state;
  std::unique_ptr<SoftRoom> room;
};

} // namespace palpate::test
