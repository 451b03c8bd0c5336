// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/compliance/servo/HeldFaces.h"
#include "haptics/compliance/servo/SoftSurfaceRef.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// A soft body as its worker had it at one moment, and the scene that it is felt in. Immutable; the servo reads it.
struct PressedBody
{
  std::uint64_t revision = 0;         ///< above 0, another one for each snapshot
  double period_s = 0.0;              ///< usual time from snapshot to snapshot; 0: each tick has its own
  std::shared_ptr<const Scene> scene; ///< all that is touched, the free surface of the body among it
  std::uint64_t beside = 0;           ///< geometryHash() of the scene that all but this surface is of; 0: there is none
  std::shared_ptr<const ComplianceSnapshot> snapshot;
  SoftSurfaceRef touch; ///< that snapshot, and which surface of the scene it is of
  std::shared_ptr<const TriangleMesh>
    heldFaces;                       ///< of the body, which nothing moves (HeldFaces.h); null: there are none
  std::shared_ptr<const Scene> held; ///< of these faces; a recording has the faces alone
};

/// The servo's report to the worker of a soft body: position and force of the ball.
struct BodyHand
{
  static constexpr int most = GodObjectState::maxFeatures;

  std::uint64_t tick = 0;
  std::uint64_t revision = 0;   ///< of the snapshot whose vertices the forces are at
  Vec3 device_W = Vec3::Zero(); ///< where the hand is [u]
  Vec3 ball_W = Vec3::Zero();   ///< among the free surfaces [u]
  Vec3 velocity_u_per_s = Vec3::Zero();
  double radius_u = 0.0; ///< of a ball
  double tip_u = 0.0;    ///< of a point contact
  int count = 0;
  std::array<SurfacePoint, most> forceAt{};
  std::array<Vec3, most> force_N{}; ///< on the body
};

} // namespace palpate
