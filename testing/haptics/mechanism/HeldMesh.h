// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

#include "haptics/compliance/snapshot/PointCompliance.h"
#include "haptics/mechanism/found/ContactFinder.h"
#include "haptics/session/mechanism/MechanismTouch.h"
#include "testing/haptics/compliance/Blocks.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{

inline constexpr double padYoung_Pa = 20e3, padPoisson = 0.4;

inline std::shared_ptr<const SidedSurface> heldMesh(const TriangleMesh& mesh)
{
  auto made = makeRigidMesh(mesh);
  if (!made.ok())
  {
    throw std::runtime_error(made.problem);
  }
  return made.value;
}

/// A mesh in the hand and the pad of Blocks.h, n cells along it, with the contacts between them found.
inline MechanismInputs meshOnPad(const TriangleMesh& mesh, int n, double friction = 0.0)
{
  MechanismInputs inputs;
  MechanismBody tool, block;
  tool.name = "tool";
  tool.kind = MechanismBodyKind::Held;
  tool.mesh = heldMesh(mesh);
  block.name = "block";
  block.kind = MechanismBodyKind::Soft;
  inputs.mechanism.bodies = { tool, block };
  inputs.mechanism.findsContacts = true;
  inputs.mechanism.foundFriction = friction;
  SoftBodyInput soft = pad(n);
  soft.poisson = padPoisson;
  soft.model = ElasticModel::Linear;
  inputs.soft = { { "block", std::make_shared<const SoftBodyInput>(soft) } };
  return inputs;
}

/// Held so stiffly that the mesh is nearly where the hand is.
inline MechanismHold firmHold(double lowRate_Hz = 30.0)
{
  MechanismHold hold;
  hold.stiffness_N_per_m = 1e4;
  hold.turning_N_m_per_rad = 10.0;
  hold.lowRate_Hz = lowRate_Hz;
  return hold;
}

/// Along a path, a tick at a time.
class MeshTouch
{
public:
  explicit MeshTouch(const MechanismInputs& inputs, const MechanismHold& hold = firmHold())
  {
    std::string refusal;
    this->touch_ = MechanismTouch::make(inputs, hold, refusal);
    if (!this->touch_)
    {
      throw std::runtime_error(refusal);
    }
  }

  const MechanismResult& to(const Pose& hand_W, double dt_s = 1e-3, int ticks = 1)
  {
    for (int i = 0; i < ticks; ++i)
    {
      this->time_s_ += dt_s;
      this->result_ = this->touch_->next(this->time_s_, hand_W);
    }
    return this->result_;
  }
  const MechanismResult& to(const Vec3& hand_W, double dt_s = 1e-3, int ticks = 1)
  {
    return this->to(Pose{ hand_W, Quat::Identity() }, dt_s, ticks);
  }

  [[nodiscard]] const MechanismTouch& touch() const { return *this->touch_; }
  [[nodiscard]] const PressedBody& body() const { return *this->touch_->bodies().newest().front(); }

private:
  std::unique_ptr<MechanismTouch> touch_;
  MechanismResult result_;
  double time_s_ = 0.0;
};

/// Where the vertices of a body are under the forces of a tick.
inline std::vector<Vec3> bentBy(const MechanismResult& result, const PressedBody& body)
{
  std::vector<Vec3> bent_W = body.snapshot->free_W;
  std::vector<CompliantPoint> from;
  for (int p = 0; p < result.pressCount; ++p)
  {
    from.push_back(compliantPoint(*body.snapshot, result.presses[static_cast<std::size_t>(p)].at));
  }
  for (std::uint32_t v = 0; v < bent_W.size(); ++v)
  {
    const SurfacePoint place{ { v, v, v }, Vec3::UnitX(), body.snapshot->free_W[v] };
    const CompliantPoint at = compliantPoint(*body.snapshot, place);
    for (std::size_t p = 0; p < from.size(); ++p)
    {
      bent_W[v] += complianceBetween(*body.snapshot, at, from[p]) * result.presses[p].force_N;
    }
  }
  return bent_W;
}

/// One body that is not computed anew, so that a shot costs its ticks alone.
struct Range
{
  Range(const TriangleMesh& mesh, const PressedBody& body, double friction) : body(body), mesh(heldMesh(mesh))
  {
    Mechanism m;
    MechanismBody tool, block;
    tool.name = "tool";
    tool.kind = MechanismBodyKind::Held;
    tool.mesh = this->mesh;
    block.name = "block";
    block.kind = MechanismBodyKind::Soft;
    m.bodies = { tool, block };
    m.findsContacts = true;
    m.foundFriction = friction;
    this->most = static_cast<std::size_t>(roomForFound(m));
    const std::vector<MechanismSoft> soft{ { "block", &this->body } };
    this->plan = planMechanism(m, soft, 1);
    this->friction = friction;
  }

  [[nodiscard]] std::vector<FinderMesh> meshes() const { return { { this->plan.held, this->mesh, this->friction } }; }

  const PressedBody& body;
  std::shared_ptr<const SidedSurface> mesh;
  MechanismPlan plan;
  double friction = 0.0;
  std::size_t most = 0;
};

} // namespace palpate::test
