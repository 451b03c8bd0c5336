// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "HeldMesh.h"
#include "haptics/core/PoseMath.h"

namespace palpate::test
{

inline constexpr double gravity_m_per_s2 = 9.81, stone_kg_per_m3 = 2500.0;

/// A small cube in the hand, loose boxes, and a table whose top goes through the origin; in metres.
class LooseRig
{
public:
  static constexpr double pusher_m = 0.005; ///< half an edge
  static constexpr int held = 0, table = 1, first = 2;

  /// `slope_W`: turns the table, and the boxes on it, about the origin.
  explicit LooseRig(double friction, const Quat& slope_W = Quat::Identity()) : slope_W_(slope_W)
  {
    MechanismBody hand, top;
    hand.name = "hand";
    hand.kind = MechanismBodyKind::Held;
    hand.mesh = heldMesh(boxOf(Vec3::Constant(pusher_m)));
    top.name = "table";
    TriangleMesh slab = boxOf(Vec3(1.0, 1.0, 0.05));
    for (Vec3& p : slab.vertices_W)
    {
      p = slope_W * Vec3(p - 0.05 * Vec3::UnitZ());
    }
    top.mesh = heldMesh(slab);
    this->inputs.mechanism.bodies = { hand, top };
    this->inputs.mechanism.findsContacts = true;
    this->inputs.mechanism.foundFriction = friction;
  }

  /// A box whose centre is there in the table's frame, under its weight.
  MechanismBody& add(const Vec3& half_m, const Vec3& at_T, const Quat& turn_T = Quat::Identity())
  {
    MechanismBody box;
    box.name = "box " + std::to_string(this->inputs.mechanism.bodies.size() - first);
    box.kind = MechanismBodyKind::Rigid;
    box.halfSize_u = half_m;
    box.pose_W = { this->slope_W_ * at_T, this->slope_W_ * turn_T };
    if (const MassGiven given = giveMass(box, stone_kg_per_m3, 1.0); !given.refusal.empty())
    {
      throw std::runtime_error(given.refusal);
    }
    box.load_W = -gravity_m_per_s2 * box.mass.mass_Ns2_per_u * Vec3::UnitZ();
    return this->inputs.mechanism.bodies.emplace_back(box);
  }

  /// The constraints alone join the bodies: a rod in the hand, no table, and boxes that meet nothing.
  void meetNothing(const std::vector<MechanismConstraint>& laws)
  {
    this->inputs.mechanism.findsContacts = false;
    MechanismBody& hand = this->inputs.mechanism.bodies[held];
    hand.mesh.reset();
    hand.length_u = 0.01;
    hand.diameter_u = 0.002;
    this->inputs.mechanism.bodies[table].mesh.reset();
    this->inputs.mechanism.laws = laws;
  }

  MechanismInputs inputs;

private:
  Quat slope_W_;
};

/// Ticks of such a mechanism, the hand far away unless it is led.
class LooseRun
{
public:
  explicit LooseRun(const MechanismInputs& inputs, double dt_s = 1e-3, const MechanismHold& hold = firmHold())
    : inputs_(inputs), touch_(inputs, hold), dt_s_(dt_s)
  {
  }

  const MechanismResult& next(const Vec3& hand_W = Vec3(-0.5, -0.5, 0.5))
  {
    this->result_ = &this->touch_.to(hand_W, this->dt_s_);
    return *this->result_;
  }
  const MechanismResult& rest(double for_s)
  {
    for (double t = 0.0; t < for_s - 0.5 * this->dt_s_; t += this->dt_s_)
    {
      (void)this->next();
    }
    return *this->result_;
  }

  [[nodiscard]] const MechanismTouch& touch() const { return this->touch_.touch(); }
  [[nodiscard]] const Pose& pose_W(int body) const { return this->result_->pose_W[static_cast<std::size_t>(body)]; }
  [[nodiscard]] const MechanismBody& body(int b) const
  {
    return this->inputs_.mechanism.bodies[static_cast<std::size_t>(b)];
  }

  /// Force and moment about the origin that found contacts exert on a body, those with one other body or with all.
  [[nodiscard]] std::pair<Vec3, Vec3> pressOn(int body, int from = -1) const
  {
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    const FoundContacts& found = this->touch().bodies().found();
    for (int i = 0; i < this->result_->found; ++i)
    {
      const FoundContact& contact = found.contacts[static_cast<std::size_t>(i)];
      const ConstraintNow& now = this->result_->laws[static_cast<std::size_t>(this->touch().plan().lawCount + i)];
      const bool isA = contact.mesh == body;
      if ((isA || contact.body == body) && (from < 0 || (isA ? contact.body : contact.mesh) == from))
      {
        force += isA ? now.force_W : Vec3(-now.force_W);
        moment += now.at_W.cross(isA ? now.force_W : Vec3(-now.force_W));
      }
    }
    return { force, moment };
  }

private:
  MechanismInputs inputs_;
  MeshTouch touch_;
  double dt_s_;
  const MechanismResult* result_ = nullptr;
};

} // namespace palpate::test
