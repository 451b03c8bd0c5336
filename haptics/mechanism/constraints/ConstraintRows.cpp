// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/constraints/ConstraintRows.h"

#include "haptics/core/PoseMath.h"

namespace palpate
{
namespace
{

constexpr double unlimited = MechanismConstraint::unlimited;

Vec3 freePlace_W(const ComplianceSnapshot& snapshot, const SurfacePoint& at) noexcept
{
  Vec3 x_W = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
  {
    x_W += at.weights[c] * snapshot.free_W[at.vertices[c]];
  }
  return x_W;
}

/// The rows of one constraint after another.
class RowMaker
{
public:
  RowMaker(const ConstraintScene& scene, ConstraintRows& rows) noexcept : scene_(scene), rows_(rows) {}

  /// Cones are the solver's last rows.
  void make(bool cones) noexcept
  {
    for (int l = 0; l < this->scene_.plan.lawCount; ++l)
    {
      const PlannedConstraint& law = this->scene_.plan.laws[l];
      const ConstraintState& state = this->scene_.laws[l];
      const bool holds = state.phase != ConstraintPhase::Gone && !state.waits;
      if ((law.kind == ConstraintKind::Friction) == cones && holds && this->place(l))
      {
        this->law_ = l;
        this->add(law, state);
      }
    }
  }

private:
  [[nodiscard]] bool place(int l) noexcept
  {
    const PlannedConstraint& law = this->scene_.plan.laws[l];
    const ConstraintState& state = this->scene_.laws[l];
    auto& [a, b] = this->rows_.ends[l];
    return this->placeEnd(law.a, law.point_A, law.axis_A, state.place_A, a) &&
           this->placeEnd(law.b, law.point_B, law.axis_B, state.place_B, b);
  }

  [[nodiscard]] bool placeEnd(
    int body, const Vec3& point, const Vec3& axis, const SurfacePoint& place, ConstraintEnd& end) const noexcept
  {
    const PlannedBody& planned = this->scene_.plan.bodies[body];
    const Pose& pose = this->scene_.pose_W[body];
    end = {};
    end.body = body;
    end.axis_W = pose.q * axis;
    end.x_W = pose * point;
    if (planned.kind != MechanismBodyKind::Soft)
    {
      return true;
    }
    const PressedBody* soft = this->scene_.soft[planned.soft];
    if (soft == nullptr)
    {
      return false;
    }
    SurfacePoint at = place;
    at.x_W = freePlace_W(*soft->snapshot, place);
    end.x_W = at.x_W;
    end.soft = planned.soft;
    end.point = compliantPoint(*soft->snapshot, at);
    return true;
  }

  void add(const PlannedConstraint& law, const ConstraintState& state) noexcept
  {
    const Vec3& axis_W = this->rows_.ends[this->law_][1].axis_W;
    switch (law.kind)
    {
      case ConstraintKind::Contact:
        return this->addPush(axis_W, 0.0, 0.0);
      case ConstraintKind::Friction:
        return this->addCone(law, state, axis_W);
      case ConstraintKind::Attachment:
      case ConstraintKind::Break:
        return this->addPoint();
      case ConstraintKind::Hinge:
        this->addPoint();
        return this->addTurns(axis_W);
      case ConstraintKind::Slider:
        this->addAcross(axis_W);
        return this->addTurns(axis_W);
      case ConstraintKind::DryFriction:
        return this->addDry(axis_W, this->before_u(axis_W), law, state);
      case ConstraintKind::Spring:
        return this->addHold(axis_W, law.rest_u, law.compliance_u_per_N);
      case ConstraintKind::Limit:
        return this->addLimit(axis_W, law);
      case ConstraintKind::Puncture:
      case ConstraintKind::Insertion:
        return this->addNeedle(law, state);
    }
  }

  /// How far A's point is before B's along a direction, rows' soft offset with it.
  [[nodiscard]] double before_u(const Vec3& along_W) const noexcept
  {
    const auto& [a, b] = this->rows_.ends[this->law_];
    return along_W.dot(a.x_W - b.x_W + this->scene_.laws[this->law_].offset_W);
  }

  void addRow(const ConstraintRow& row) noexcept
  {
    if (this->rows_.count < ConstraintRows::most)
    {
      this->rows_.rows[this->rows_.count++] = row;
    }
  }
  void addHold(const Vec3& along_W, double from_u, double compliance) noexcept
  {
    this->addRow({ this->law_, false, along_W, this->before_u(along_W) - from_u, -unlimited, unlimited, compliance });
  }
  void addPush(const Vec3& along_W, double from_u, double compliance) noexcept
  {
    this->addRow({ this->law_, false, along_W, this->before_u(along_W) - from_u, 0.0, unlimited, compliance });
  }

  void addPoint() noexcept
  {
    for (int k = 0; k < 3; ++k)
    {
      this->addHold(Vec3::Unit(k), 0.0, 0.0);
    }
  }

  void addAcross(const Vec3& axis_W) noexcept
  {
    const Vec3 first_W = axis_W.unitOrthogonal();
    this->addHold(first_W, 0.0, 0.0);
    this->addHold(axis_W.cross(first_W), 0.0, 0.0);
  }

  /// Both axes have the same direction: the turn from B's to A's, across B's.
  void addTurns(const Vec3& axis_W) noexcept
  {
    const Vec3 turn = axis_W.cross(this->rows_.ends[this->law_][0].axis_W);
    const Vec3 first_W = axis_W.unitOrthogonal();
    for (const Vec3& along_W : { first_W, Vec3(axis_W.cross(first_W)) })
    {
      this->addRow(
        { this->law_, true, along_W, this->scene_.plan.characteristic_u * along_W.dot(turn), -unlimited, unlimited });
    }
  }

  void addDry(const Vec3& axis_W, double now_u, const PlannedConstraint& law, const ConstraintState& state) noexcept
  {
    this->addRow({ this->law_, false, axis_W, state.placed ? now_u - state.stuck_u.x() : 0.0, -law.dryFriction_N,
      law.dryFriction_N, 0.0, true, now_u });
  }

  void addLimit(const Vec3& axis_W, const PlannedConstraint& law) noexcept
  {
    if (std::isfinite(law.least_u))
    {
      this->addPush(axis_W, law.least_u, law.compliance_u_per_N);
    }
    if (std::isfinite(law.most_u))
    {
      this->addPush(-axis_W, -law.most_u, law.compliance_u_per_N);
    }
  }

  void addCone(const PlannedConstraint& law, const ConstraintState& state, const Vec3& n_W) noexcept
  {
    const auto& [a, b] = this->rows_.ends[this->law_];
    const Vec3 apart_W = a.x_W - b.x_W + state.offset_W;
    const Vec3 slipped_W = state.placed ? Vec3(apart_W - state.stuck_u) : Vec3(Vec3::Zero());
    this->addPush(n_W, 0.0, 0.0);
    const Vec3 first_W = n_W.unitOrthogonal();
    for (const Vec3& along_W : { first_W, Vec3(n_W.cross(first_W)) })
    {
      this->addRow({ this->law_, false, along_W, along_W.dot(slipped_W), -unlimited, unlimited });
    }
    this->rows_.friction[static_cast<std::size_t>(this->rows_.cones++)] = law.friction;
  }

  /// A tip before the surface, or a shaft through a hole: A's point is then where the hole is along it.
  void addNeedle(const PlannedConstraint& law, const ConstraintState& state) noexcept
  {
    auto& [a, b] = this->rows_.ends[this->law_];
    const PlannedBody& rod = this->scene_.plan.bodies[law.a];
    const Pose& pose = this->scene_.pose_W[law.a];
    a.axis_W = pose.q * Vec3::UnitZ();
    if (!inShaft(law, state))
    {
      a.x_W = pose.p + rod.length_u * a.axis_W;
      return this->addTip(law, state);
    }
    const double tip_u = rod.length_u - a.axis_W.dot(b.x_W - state.offset_W - pose.p);
    // The shaft is pressed where the hole has yielded to, which is not where it is without forces.
    const Vec3 hole_W = state.seen ? Vec3(-state.apart_W) : b.x_W;
    a.x_W = pose.p + a.axis_W.dot(hole_W - state.offset_W - pose.p) * a.axis_W;
    this->addAcross(a.axis_W);
    this->addDry(a.axis_W, tip_u, law, state);
    // A rod ends at the hand: no more of it goes in than there is.
    this->addRow({ this->law_, false, -a.axis_W, rod.length_u - tip_u, 0.0, unlimited });
  }

  /// One that pricks stays where it met the surface; else it slides.
  void addTip(const PlannedConstraint& law, const ConstraintState& state) noexcept
  {
    if (!state.met)
    {
      return;
    }
    this->addPush(state.normal_W, 0.0, 0.0);
    if (law.friction > 0.0)
    {
      this->addAcross(state.normal_W);
    }
  }

  const ConstraintScene& scene_;
  ConstraintRows& rows_;
  int law_ = 0;
};

} // namespace

bool inShaft(const PlannedConstraint& law, const ConstraintState& state) noexcept
{
  return law.kind == ConstraintKind::Insertion ||
         (law.kind == ConstraintKind::Puncture && state.phase == ConstraintPhase::Inside);
}

void makeRows(const ConstraintScene& scene, ConstraintRows& rows) noexcept
{
  rows.count = rows.cones = 0;
  RowMaker maker(scene, rows);
  maker.make(false);
  maker.make(true);
}

bool isAlongAxis(ConstraintKind kind) noexcept
{
  switch (kind)
  {
    case ConstraintKind::Contact:
    case ConstraintKind::Slider:
    case ConstraintKind::Friction:
    case ConstraintKind::DryFriction:
    case ConstraintKind::Spring:
    case ConstraintKind::Limit:
      return true;
    case ConstraintKind::Attachment:
    case ConstraintKind::Hinge:
    case ConstraintKind::Break:
    case ConstraintKind::Puncture:
    case ConstraintKind::Insertion:
      return false;
  }
  return false;
}

Vec3 armOf(const ConstraintScene& scene, const ConstraintRows& rows, int law, int side) noexcept
{
  const ConstraintEnd& end = rows.ends[law][side];
  const bool turns = end.body == scene.plan.held || isLoose(scene.plan.bodies[end.body]);
  const bool atA = isAlongAxis(scene.plan.laws[law].kind) && turns && rows.ends[law][0].soft < 0;
  return (atA ? rows.ends[law][0] : end).x_W - scene.pose_W[end.body].p;
}

Vec6 jacobianOf(const ConstraintScene& scene, const ConstraintRows& rows, const ConstraintRow& row, int side) noexcept
{
  const double sign = side == 0 ? 1.0 : -1.0;
  if (row.turns)
  {
    return whitened(Vec3::Zero(), sign / scene.plan.characteristic_u * row.along_W, scene.plan.characteristic_u);
  }
  const Vec3 arm_W = armOf(scene, rows, row.law, side);
  Vec6 j;
  j << sign * row.along_W, sign / scene.plan.characteristic_u * arm_W.cross(row.along_W);
  return j;
}

} // namespace palpate
