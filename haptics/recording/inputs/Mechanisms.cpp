// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/inputs/Mechanisms.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "haptics/recording/inputs/Bodies.h"
#include "haptics/recording/inputs/Places.h"
#include "haptics/recording/inputs/Wires.h"

namespace palpate
{
namespace
{

bool isPlace(const SurfacePoint& at)
{
  return at.weights.allFinite() && at.x_W.allFinite();
}

template<class Io, class Plan>
void layPlan(const Io& io, Plan& plan)
{
  io(plan.revision);
  io(plan.characteristic_u);
  io(plan.farthest_u);
  io(plan.bodyCount);
  io(plan.lawCount);
  io(plan.held);
}

template<class Io, class Body>
void layBody(const Io& io, Body& body)
{
  io(body.kind);
  io(body.soft);
  io(body.length_u);
  io(body.pose_W);
  io(body.load_W);
  io(body.mass);
  io(body.low_u);
  io(body.high_u);
}

template<class Io, class Constraint>
void layConstraint(const Io& io, Constraint& law)
{
  io(law.kind);
  io(law.a);
  io(law.b);
  for (auto* const vector : { &law.point_A, &law.point_B, &law.axis_A, &law.axis_B })
  {
    io(*vector);
  }
  for (auto* const number : { &law.strength_N, &law.tear_N, &law.friction, &law.dryFriction_N, &law.compliance_u_per_N,
         &law.rest_u, &law.least_u, &law.most_u })
  {
    io(*number);
  }
  io(law.place_A);
  io(law.place_B);
}

void readPlan(ByteReader& in, MechanismPlan& plan)
{
  layPlan(Get{ in }, plan);
  in.failUnless(plan.bodyCount > 0 && plan.bodyCount <= static_cast<int>(plan.bodies.size()) && plan.lawCount >= 0 &&
                plan.lawCount <= static_cast<int>(plan.laws.size()) && plan.held >= 0 && plan.held < plan.bodyCount &&
                plan.characteristic_u > 0.0 && std::isfinite(plan.characteristic_u) && plan.farthest_u > 0.0);
  for (int b = 0; in.ok() && b < plan.bodyCount; ++b)
  {
    layBody(Get{ in }, plan.bodies[static_cast<std::size_t>(b)]);
  }
  for (int l = 0; in.ok() && l < plan.lawCount; ++l)
  {
    layConstraint(Get{ in }, plan.laws[static_cast<std::size_t>(l)]);
  }
}

RecordedMechanism::Body readSoft(ByteReader& in)
{
  RecordedMechanism::Body recorded;
  in.get(recorded.sceneHash);
  in.get(recorded.sceneRevision);
  const auto read = readBody(in);
  if (!read)
  {
    return recorded;
  }
  auto snapshot = std::make_shared<ComplianceSnapshot>(*read->snapshot);
  snapshot->free_W.resize(in.has(snapshot->placeOf.size() * 3 * sizeof(double)) ? snapshot->placeOf.size() : 0);
  for (Vec3& x_W : snapshot->free_W)
  {
    in.get(x_W);
    in.failUnless(x_W.allFinite());
  }
  auto body = std::make_shared<PressedBody>(*read);
  body->touch.snapshot = snapshot.get();
  body->snapshot = std::move(snapshot);
  recorded.body = std::move(body);
  return recorded;
}

bool isUsable(const PlannedBody& body, std::size_t softCount)
{
  const bool soft = body.kind == MechanismBodyKind::Soft;
  return body.kind <= MechanismBodyKind::Wire && (soft ? body.soft >= 0 : body.soft == -1) &&
         body.soft < static_cast<int>(softCount) && std::isfinite(body.length_u) && isPlace(body.pose_W) &&
         body.load_W.allFinite() && isValid(body.mass) && body.low_u.allFinite() && body.high_u.allFinite();
}

/// Strengths and bounds may be unlimited.
bool isUsable(const PlannedConstraint& law)
{
  const auto notNegative = [](double value) { return std::isfinite(value) && value >= 0.0; };
  const bool numbers = notNegative(law.friction) && notNegative(law.dryFriction_N) &&
                       notNegative(law.compliance_u_per_N) && law.strength_N > 0.0 && law.tear_N > 0.0 &&
                       std::isfinite(law.rest_u) && !std::isnan(law.least_u) && !std::isnan(law.most_u);
  return law.kind <= ConstraintKind::Insertion && numbers && law.point_A.allFinite() && law.point_B.allFinite() &&
         law.axis_A.allFinite() && law.axis_B.allFinite() && isPlace(law.place_A) && isPlace(law.place_B);
}

bool hasVertices(const SurfacePoint& at, int body, const RecordedMechanism& mechanism)
{
  const int soft = mechanism.plan.bodies[static_cast<std::size_t>(body)].soft;
  const std::size_t vertices =
    soft < 0 ? 0 : mechanism.bodies[static_cast<std::size_t>(soft)].body->snapshot->placeOf.size();
  return soft < 0 || std::ranges::all_of(at.vertices, [vertices](std::uint32_t v) { return v < vertices; });
}

bool isUsable(const FoundContacts& found)
{
  const bool counts = found.count >= 0 && found.count <= FoundContacts::most && found.leftOut >= 0;
  return counts && !std::isnan(found.reach_u) && isPlace(found.held_W) &&
         std::ranges::all_of(found.contacts,
           [](const FoundContact& contact)
           {
             const double length = contact.normal_B.norm();
             return contact.point_A.allFinite() && isPlace(contact.place_A) && isPlace(contact.place_B) &&
                    std::abs(length - 1.0) <= offUnitLength && std::isfinite(contact.apart_u) &&
                    std::isfinite(contact.friction) && contact.friction >= 0.0;
           });
}

/// Whether they are of two bodies of the mechanism that may meet, at vertices that soft ones have.
bool fits(const FoundContacts& found, const RecordedMechanism& mechanism)
{
  return std::all_of(found.contacts.begin(), found.contacts.begin() + found.count,
    [&mechanism](const FoundContact& contact)
    {
      const auto softOf = [&mechanism](int body) { return mechanism.plan.bodies[static_cast<std::size_t>(body)].soft; };
      const auto isMet = [&](const FoundContact& met)
      {
        const auto& bodies = mechanism.plan.bodies;
        const PlannedBody& body = bodies[static_cast<std::size_t>(met.body)];
        const bool loose = isLoose(body) || isLoose(bodies[static_cast<std::size_t>(met.mesh)]);
        const bool meetsRigid = softOf(met.mesh) < 0 && (body.kind == MechanismBodyKind::World || loose);
        return met.mesh != met.body && (softOf(met.body) >= 0 || meetsRigid);
      };
      const auto there = [&mechanism](int body) { return body >= 0 && body < mechanism.plan.bodyCount; };
      return there(contact.mesh) && there(contact.body) && isMet(contact) &&
             hasVertices(contact.place_A, contact.mesh, mechanism) &&
             hasVertices(contact.place_B, contact.body, mechanism);
    });
}

/// Whether the rows of the plan and of the contacts that were found are no more than the solver takes.
bool hasRoom(const FoundContacts& found, const MechanismPlan& plan, int rows)
{
  for (int i = 0; i < found.count; ++i)
  {
    const bool rubs = found.contacts[static_cast<std::size_t>(i)].friction > 0.0;
    rows += mostRowsOf(rubs ? ConstraintKind::Friction : ConstraintKind::Contact);
  }
  return rows <= Mechanism::mostRows && plan.lawCount + found.count <= static_cast<int>(plan.laws.size());
}

/// Whether the plan fits into the tick's fixed memory and its indices exist.
bool isUsable(const RecordedMechanism& mechanism)
{
  const MechanismPlan& plan = mechanism.plan;
  const std::span bodies(plan.bodies.data(), static_cast<std::size_t>(plan.bodyCount));
  const std::span laws(plan.laws.data(), static_cast<std::size_t>(plan.lawCount));
  const auto rigid = std::ranges::count_if(
    bodies, [](const PlannedBody& b) { return b.kind == MechanismBodyKind::Rigid && !isLoose(b); });
  int rows = 0;
  for (const PlannedConstraint& law : laws)
  {
    rows += law.kind <= ConstraintKind::Insertion ? mostRowsOf(law.kind) : 0;
  }
  const auto joins = [&mechanism, &plan](const PlannedConstraint& law)
  {
    const bool there = law.a >= 0 && law.a < plan.bodyCount && law.b >= 0 && law.b < plan.bodyCount;
    return there && hasVertices(law.place_A, law.a, mechanism) && hasVertices(law.place_B, law.b, mechanism);
  };
  const std::size_t softCount = mechanism.bodies.size();
  const MechanismBodyKind inHand = plan.wire ? MechanismBodyKind::Wire : MechanismBodyKind::Held;
  const auto oneHeld = std::ranges::count_if(bodies, [](const PlannedBody& b) { return isInHand(b.kind); });
  const bool alone = plan.bodyCount == 1 && plan.lawCount == 0 && mechanism.found.count == 0;
  return std::ranges::all_of(bodies, [softCount](const PlannedBody& b) { return isUsable(b, softCount); }) &&
         std::ranges::all_of(laws, [&joins](const PlannedConstraint& law) { return isUsable(law) && joins(law); }) &&
         6 * rigid + 3 <= ConstraintProblem::mostWays && rows <= Mechanism::mostRows && oneHeld == 1 &&
         isUsable(mechanism.found) && fits(mechanism.found, mechanism) && hasRoom(mechanism.found, plan, rows) &&
         bodies[static_cast<std::size_t>(plan.held)].kind == inHand && (!plan.wire || alone);
}

bool isUsable(const LooseMotion& motion)
{
  return motion.speed_W.allFinite() && motion.spin_B.allFinite() && std::isfinite(motion.calm_s);
}

bool isUsable(const ConstraintState& law)
{
  return law.phase <= ConstraintPhase::Gone && isPlace(law.place_A) && isPlace(law.place_B) &&
         law.normal_W.allFinite() && law.stuck_u.allFinite() && law.force_W.allFinite() && law.offset_W.allFinite() &&
         law.apart_W.allFinite();
}

} // namespace

void putMechanism(ByteWriter& payload, const FeltMechanism& mechanism)
{
  const MechanismPlan& plan = mechanism.plan();
  const Put put{ payload };
  put(mechanism.revision());
  layPlan(put, plan);
  for (int b = 0; b < plan.bodyCount; ++b)
  {
    layBody(put, plan.bodies[static_cast<std::size_t>(b)]);
  }
  for (int l = 0; l < plan.lawCount; ++l)
  {
    layConstraint(put, plan.laws[static_cast<std::size_t>(l)]);
  }
  put(static_cast<std::uint64_t>(mechanism.bodies().size()));
  for (const auto& body : mechanism.bodies())
  {
    put(body->scene->contentHash());
    put(body->scene->revision());
    putBody(payload, *body);
    for (const Vec3& x_W : body->snapshot->free_W)
    {
      put(x_W);
    }
  }
  put(mechanism.found() ? *mechanism.found() : FoundContacts());
  put(mechanism.meshes() ? mechanism.meshes()->scene()->contentHash() : std::uint64_t{ 0 });
  put(mechanism.meshes() ? mechanism.meshes()->scene()->revision() : std::uint64_t{ 0 });
  if (plan.wire)
  {
    putWire(payload, *plan.wire);
  }
}

RecordedMechanism readMechanism(ByteReader& in)
{
  RecordedMechanism mechanism;
  in.get(mechanism.revision);
  readPlan(in, mechanism.plan);
  const std::uint64_t bodies = in.count(2 * sizeof(std::uint64_t));
  in.failUnless(bodies <= Mechanism::mostBodies);
  for (std::uint64_t i = 0; in.ok() && i < bodies; ++i)
  {
    mechanism.bodies.push_back(readSoft(in));
  }
  in.get(mechanism.found);
  in.get(mechanism.meshesHash);
  in.get(mechanism.meshesRevision);
  if (in.ok() && in.left() != 0)
  {
    mechanism.plan.wire = readWire(in, mechanism.vessel_W);
  }
  in.failUnless(in.ok() && isUsable(mechanism));
  return mechanism;
}

bool isUsable(const MechanismState& state)
{
  return std::ranges::all_of(state.laws, [](const ConstraintState& law) { return isUsable(law); }) &&
         std::ranges::all_of(state.loose, [](const LooseMotion& motion) { return isUsable(motion); }) &&
         isUsable(state.found) && std::ranges::all_of(state.pose_W, [](const Pose& pose) { return isPlace(pose); }) &&
         state.push_N.allFinite() && state.turning_N.allFinite() && isPlace(state.led.hand_W) &&
         isPlace(state.led.lead_W) && state.tip_W.allFinite() && std::isfinite(state.soft.given_Nu) &&
         std::isfinite(state.soft.held_Nu) && state.blend.way_u.allFinite() && state.blend.turn_u.allFinite() &&
         isUsable(state.wire);
}

bool fits(const MechanismState& state, const RecordedMechanism& mechanism)
{
  const MechanismPlan& plan = mechanism.plan;
  bool there = state.revision != plan.revision || fits(state.found, mechanism);
  for (int l = 0; l < plan.lawCount && state.revision == plan.revision; ++l)
  {
    const auto i = static_cast<std::size_t>(l);
    there = there && hasVertices(state.laws[i].place_A, plan.laws[i].a, mechanism) &&
            hasVertices(state.laws[i].place_B, plan.laws[i].b, mechanism);
  }
  return there;
}

} // namespace palpate
