// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <numeric>
#include <stdexcept>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/mechanism/check/MechanismCheck.h"
#include "haptics/mechanism/servo/MechanismTick.h"

namespace palpate::test
{

/// The hand and the tissue of docs/theory.md, "Constraints between bodies" [N/m, N m/rad].
inline constexpr double kc = 1000.0, kr = 2.0, tissue = 500.0;

/// A body of that surface that yields as a whole: one spring, the same along every axis.
inline std::shared_ptr<const PressedBody> springBody(const std::string& name, std::shared_ptr<const TriangleMesh> mesh,
  double patchRadius_u, double compliance_u_per_N, std::uint64_t revision = 1)
{
  SurfaceInput input;
  input.name = name;
  input.mesh = mesh;
  input.ordered = true;
  SceneBuilder builder;
  const std::size_t count = mesh->vertices_W.size();
  auto snapshot = std::make_shared<ComplianceSnapshot>();
  snapshot->free_W = mesh->vertices_W;
  snapshot->near.resize(count);
  std::iota(snapshot->near.begin(), snapshot->near.end(), 0);
  snapshot->placeOf.assign(snapshot->near.begin(), snapshot->near.end());
  snapshot->compliance = Mat3(compliance_u_per_N * Mat3::Identity())
                           .replicate(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
  snapshot->springs.resize(count);
  snapshot->patchRadius_u.assign(count, patchRadius_u);
  auto body = std::make_shared<PressedBody>();
  body->revision = revision;
  body->scene = builder.build({ input }, nullptr).scene;
  if (!body->scene)
  {
    throw std::runtime_error("the surface is no scene");
  }
  body->snapshot = snapshot;
  body->touch = { 0, snapshot.get() };
  return body;
}

/// A square of two triangles.
inline std::shared_ptr<const PressedBody> springWall(const std::string& name, const Vec3& centre_W,
  const Vec3& normal_W, double half_u, double compliance_u_per_N, std::uint64_t revision = 1)
{
  const Vec3 u_W = half_u * normal_W.unitOrthogonal();
  const Vec3 v_W = normal_W.cross(u_W);
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->vertices_W = { centre_W - u_W - v_W, centre_W + u_W - v_W, centre_W + u_W + v_W, centre_W - u_W + v_W };
  mesh->triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  return springBody(name, mesh, half_u, compliance_u_per_N, revision);
}

/// A mechanism with its soft bodies and its tick.
class MechanismRig
{
public:
  Mechanism mechanism;
  MechanismGrip grip{ kc, kr };
  MechanismTick tick;

  explicit MechanismRig(double length_u = 0.2)
  {
    MechanismBody needle;
    needle.name = "needle";
    needle.kind = MechanismBodyKind::Held;
    needle.length_u = length_u;
    needle.diameter_u = 0.001;
    this->mechanism.bodies.push_back(needle);
    MechanismBody world;
    world.name = "world";
    this->mechanism.bodies.push_back(world);
  }

  void addSoft(const std::string& name, std::shared_ptr<const PressedBody> body)
  {
    MechanismBody soft;
    soft.name = name;
    soft.kind = MechanismBodyKind::Soft;
    this->mechanism.bodies.push_back(soft);
    this->soft.push_back({ name, body.get() });
    this->pressed.push_back(body.get());
    this->bodies_.push_back(std::move(body));
  }

  MechanismConstraint& join(ConstraintKind kind, const std::string& b, const Vec3& point_A, const Vec3& point_B)
  {
    MechanismConstraint law;
    law.name = "law " + std::to_string(this->mechanism.laws.size());
    law.kind = kind;
    law.a = "needle";
    law.b = b;
    law.point_A = point_A;
    law.point_B = point_B;
    return this->mechanism.laws.emplace_back(law);
  }

  [[nodiscard]] MechanismCheck check() const { return checkMechanism(this->mechanism, this->soft, this->grip); }

  void plan() { this->plan_ = planMechanism(this->mechanism, this->soft, ++this->revision_); }

  const MechanismResult& step(const Pose& hand_W)
  {
    if (this->revision_ == 0)
    {
      this->plan();
    }
    MechanismInput input;
    input.tick = ++this->ticks_;
    input.plan = &this->plan_;
    input.hand_W = hand_W;
    input.grip = this->grip;
    input.soft = this->pressed;
    return this->tick.step(input);
  }
  const MechanismResult& step(const Vec3& hand_W) { return this->step(Pose{ hand_W, Quat::Identity() }); }

  std::vector<MechanismSoft> soft;
  std::vector<const PressedBody*> pressed;

private:
  MechanismPlan plan_;
  std::uint64_t revision_ = 0;
  std::uint64_t ticks_ = 0;
  std::vector<std::shared_ptr<const PressedBody>> bodies_;
};

} // namespace palpate::test
