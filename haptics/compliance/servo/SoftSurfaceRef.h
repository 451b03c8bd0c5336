// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>

#include "haptics/compliance/servo/ContactProblem.h"
#include "haptics/compliance/snapshot/PointCompliance.h"
#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/GodObjectState.h"
#include "haptics/core/Fade.h"

namespace palpate
{

/// Of the offset that a change of snapshots leaves: a step of force is then at most a tenth of a newton a tick at .2
/// m/s.
inline constexpr Fade snapshotFade{ 0.02 };

/// A surface of a scene that gives way.
struct SoftSurfaceRef
{
  std::uint32_t surface = 0;                    ///< in Scene::surfaces()
  const ComplianceSnapshot* snapshot = nullptr; ///< its vertices are those of the scene's surface, at free_W
};

/// A contact that carries or carried force.
struct SoftContact
{
  ActiveFeature feature;
  Vec3 n = Vec3::Zero();                ///< unit, towards the ball
  Vec3 foot_W = Vec3::Zero();           ///< in the free surface
  double overlap_u = 0.0;               ///< of the ball with its plane, where the ball is
  const SoftSurfaceRef* soft = nullptr; ///< null: a wall; valid in the tick that found it
  bool gives = false;                   ///< it is soft, and its compliance is not 0
  CompliantPoint point;                 ///< of a soft one
  SubgridSpring spring;
  Vec3 force_N = Vec3::Zero();   ///< on the ball
  Vec3 yielded_W = Vec3::Zero(); ///< how far the surface has gone here
  Vec3 aside_W = Vec3::Zero();   ///< from the core to the ball as this contact had it where slip is counted from
};

/// State of a ball among soft bodies, kept by the servo.
struct SoftState
{
  GodObjectState core;           ///< the ball among the free surfaces: in material space
  Vec3 yielded_W = Vec3::Zero(); ///< how far the surfaces under it have gone: the ball in W is there plus this
  Vec3 offset_W = Vec3::Zero();  ///< of the surfaces: fading offset of the last change of snapshots
  Vec3 lead_W = Vec3::Zero();    ///< by which friction holds the ball before the device, as the core is told [u]
  std::array<SoftContact, GodObjectState::maxFeatures> contacts{};
  int count = 0;
};

/// Workspace of a tick of contact, kept by its owner, so that nothing is allocated.
struct SoftScratch
{
  ContactProblem problem;
  ContactForces forces;
  FrictionScratch friction;
};

/// The result of one tick.
struct SoftResult
{
  Vec3 proxy_W = Vec3::Zero(); ///< the ball, where the surfaces have yielded to
  Vec3 force_N = Vec3::Zero(); ///< on the hand
  ContactResult core;          ///< of the last move among the free surfaces
  int loops = 0;
  bool capped = false;     ///< the loop's cap ended it: forces and gaps agree for the planes of its last turn
  bool overBudget = false; ///< likewise by plan.workBudget
  std::uint32_t work = 0;  ///< done, in the unit of ContactPlan::workBudget
  double residual_u = 0.0; ///< by how much the laws of contact are not met
  /// From where slip counts, with each contact's aside_W: the core at the beginning of the tick, or where it went on
  /// from when its turns had not agreed by then.
  Vec3 slipFrom_W = Vec3::Zero();
};

} // namespace palpate
