// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <Eigen/Geometry>

#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/mechanism/check/MechanismCheck.h"
#include "haptics/mechanism/check/MechanismFaults.h"
#include "haptics/mechanism/sided/SidedSurface.h"
#include "haptics/mechanism/wire/WirePlan.h"

namespace palpate
{
namespace
{

PlannedBody planBody(const MechanismBody& body, std::span<const MechanismSoft> soft)
{
  PlannedBody planned;
  planned.kind = body.kind;
  planned.length_u = body.length_u;
  if (body.kind == MechanismBodyKind::Held)
  {
    planned.pose_W.q = body.pose_W.q.normalized();
  }
  if (body.kind == MechanismBodyKind::Rigid)
  {
    planned.pose_W = { body.pose_W.p, body.pose_W.q.normalized() };
    planned.load_W = body.load_W;
    planned.mass = body.mass;
  }
  if (body.mesh)
  {
    planned.low_u = body.mesh->tree->data().low_W;
    planned.high_u = body.mesh->tree->data().high_W;
  }
  if (body.kind == MechanismBodyKind::Soft)
  {
    planned.soft = static_cast<int>(softNamed(soft, body.name) - soft.data());
  }
  return planned;
}

PlannedConstraint planConstraint(
  const Mechanism& mechanism, const MechanismConstraint& law, std::span<const MechanismSoft> soft)
{
  PlannedConstraint planned;
  planned.kind = law.kind == ConstraintKind::Friction && law.friction == 0.0 ? ConstraintKind::Contact : law.kind;
  planned.a = bodyNamed(mechanism, law.a);
  planned.b = bodyNamed(mechanism, law.b);
  planned.point_A = law.point_A;
  planned.point_B = law.point_B;
  planned.axis_A = law.axis_A.normalized();
  planned.axis_B = law.axis_B.normalized();
  planned.strength_N = law.strength_N;
  planned.tear_N = law.tear_N;
  planned.friction = law.friction;
  planned.dryFriction_N = law.dryFriction_N;
  planned.compliance_u_per_N = 1.0 / law.stiffness_N_per_u;
  planned.rest_u = law.rest_u;
  planned.least_u = law.least_u;
  planned.most_u = law.most_u;
  if (const MechanismSoft* a = softNamed(soft, law.a))
  {
    planned.place_A = nearestPlace(*a->body, law.point_A);
  }
  if (const MechanismSoft* b = softNamed(soft, law.b))
  {
    planned.place_B = nearestPlace(*b->body, law.point_B);
  }
  return planned;
}

} // namespace

double farthestLoose_u(const Mechanism& mechanism)
{
  constexpr double scenes = 10.0;
  Eigen::AlignedBox3d bounds;
  for (const MechanismBody& body : mechanism.bodies)
  {
    const double radius_u = body.mesh ? body.mesh->radius_u : body.halfSize_u.norm();
    bounds.extend(Vec3(body.pose_W.p.array() - radius_u));
    bounds.extend(Vec3(body.pose_W.p.array() + radius_u));
  }
  const bool any = std::ranges::any_of(mechanism.bodies, [](const MechanismBody& body) { return isLoose(body); });
  return any ? scenes * bounds.diagonal().norm() : MechanismConstraint::unlimited;
}

MechanismPlan planMechanism(const Mechanism& mechanism, std::span<const MechanismSoft> soft, std::uint64_t revision)
{
  MechanismPlan plan;
  plan.revision = revision;
  double characteristic_u = 0.0;
  for (const MechanismBody& body : mechanism.bodies)
  {
    plan.held = isInHand(body.kind) ? plan.bodyCount : plan.held;
    plan.wire = body.wire ? body.wire->plan : plan.wire;
    plan.bodies[plan.bodyCount++] = planBody(body, soft);
    const double mesh_u = body.mesh ? body.mesh->radius_u : 0.0;
    characteristic_u = std::max({ characteristic_u, 0.5 * body.length_u, body.halfSize_u.norm(), mesh_u });
  }
  for (const MechanismConstraint& law : mechanism.laws)
  {
    plan.laws[plan.lawCount++] = planConstraint(mechanism, law, soft);
  }
  plan.characteristic_u = characteristic_u > 0.0 ? characteristic_u : 1.0;
  plan.farthest_u = farthestLoose_u(mechanism);
  return plan;
}

} // namespace palpate
