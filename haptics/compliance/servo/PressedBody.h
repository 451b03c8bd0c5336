// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/compliance/servo/HeldFaces.h"
#include "haptics/compliance/servo/SoftSurfaceRef.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// A soft body at one moment, from its worker, with the scene in which it is felt. Immutable; the servo reads it.
struct PressedBody
{
  std::uint64_t revision = 0;         ///< above 0, different for each snapshot
  double period_s = 0.0;              ///< usual time from snapshot to snapshot; 0: each tick has its own
  std::shared_ptr<const Scene> scene; ///< all touched surfaces, the free surface of the body among them
  std::uint64_t beside = 0;           ///< geometryHash() of the scene of all other surfaces; 0: none
  std::shared_ptr<const ComplianceSnapshot> snapshot;
  SoftSurfaceRef touch;                          ///< that snapshot, and its surface in the scene
  std::shared_ptr<const TriangleMesh> heldFaces; ///< fixed faces of the body (HeldFaces.h); null: none
  std::shared_ptr<const Scene> held;             ///< scene of these faces; a recording has the faces alone
};

/// The servo's report to the worker of a soft body: position and force of the ball.
struct BodyHand
{
  static constexpr int most = GodObjectState::maxFeatures;

  std::uint64_t tick = 0;
  std::uint64_t revision = 0;   ///< of the snapshot to whose vertices the forces belong
  Vec3 device_W = Vec3::Zero(); ///< position of the hand [u]
  Vec3 ball_W = Vec3::Zero();   ///< among the free surfaces [u]
  Vec3 velocity_u_per_s = Vec3::Zero();
  double radius_u = 0.0; ///< of a ball
  double tip_u = 0.0;    ///< of a point contact
  int count = 0;
  std::array<SurfacePoint, most> forceAt{};
  std::array<Vec3, most> force_N{}; ///< on the body
};

} // namespace palpate
