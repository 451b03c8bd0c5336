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

/// Fade of the offset that a change of snapshots leaves: with it a step of force is at most a tenth of a newton per
/// tick at .2 m/s.
inline constexpr Fade snapshotFade{ 0.02 };

/// A soft surface of a scene.
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
  double overlap_u = 0.0;               ///< of the ball with the contact's plane
  const SoftSurfaceRef* soft = nullptr; ///< null: a wall; valid in the tick that found it
  bool gives = false;                   ///< soft, and with a compliance that is not 0
  CompliantPoint point;                 ///< of a soft contact
  SubgridSpring spring;
  Vec3 force_N = Vec3::Zero();   ///< on the ball
  Vec3 yielded_W = Vec3::Zero(); ///< displacement of the surface here
  Vec3 aside_W = Vec3::Zero();   ///< from the core to this contact's ball, at the origin of slip
};

/// State of a ball among soft bodies, kept by the servo.
struct SoftState
{
  GodObjectState core;           ///< the ball among the free surfaces: in material space
  Vec3 yielded_W = Vec3::Zero(); ///< displacement of the surfaces under it: the ball in W is the core plus this
  Vec3 offset_W = Vec3::Zero();  ///< of the surfaces: fading offset of the last change of snapshots
  Vec3 lead_W = Vec3::Zero();    ///< by which friction keeps the ball ahead of the device, as given to the core [u]
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
  Vec3 proxy_W = Vec3::Zero(); ///< the ball among the displaced surfaces
  Vec3 force_N = Vec3::Zero(); ///< on the hand
  ContactResult core;          ///< of the last move among the free surfaces
  int loops = 0;
  bool capped = false;     ///< the iterations reached their cap: forces and gaps agree for the planes of the last one
  bool overBudget = false; ///< likewise by plan.workBudget
  std::uint32_t work = 0;  ///< done, in the unit of ContactPlan::workBudget
  double residual_u = 0.0; ///< residual of the contact laws
  /// The origin of slip, with each contact's aside_W: the core at the beginning of the tick, or where it went on
  /// when its iterations had not agreed.
  Vec3 slipFrom_W = Vec3::Zero();
};

} // namespace palpate
