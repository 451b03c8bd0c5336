// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>
#include <sstream>

#include "haptics/session/mechanism/BallMesh.h"
#include "haptics/session/mechanism/MechanismTouch.h"
#include "haptics/session/mechanism/SurfacesBeside.h"
#include "haptics/session/mechanism/ToolOnBody.h"
#include "haptics/session/path/PathKind.h"
#include "haptics/session/path/ToolHold.h"
#include "haptics/tool/mesh/ToolMesh.h"

namespace palpate
{
namespace
{

/// Without a stiffness of turning a lever gives one; without both the held body turns freely.
MechanismHold mechanismHoldOf(const SettingStore& settings)
{
  const double stiffness_N_per_m = settings.number("Stiffness"), scale_u_per_m = settings.number("Scale");
  const double turning_N_m_per_rad = settings.number("MechanismTurning");
  const double arm_m = settings.number("ToolLever") / scale_u_per_m;
  return { stiffness_N_per_m, turning_N_m_per_rad > 0.0 ? turning_N_m_per_rad : stiffness_N_per_m * arm_m * arm_m,
    scale_u_per_m, settings.number("SoftRate") };
}

/// A mechanism is felt as its constraints say: any other input would be lost.
std::string lostBesideMechanism(const PathInputs& inputs)
{
  const std::string lost =
    setBeside(inputs.settings, { "Stiffness", "Scale", "ToolLever", "MechanismTurning", "SoftRate" });
  const std::string beside = !lost.empty()              ? lost
                             : inputs.tool              ? inputs.tool->name
                             : inputs.field             ? inputs.field->name
                             : inputs.body              ? inputs.body->name
                             : !inputs.surfaces.empty() ? inputs.surfaces.front().name
                                                        : "";
  return beside.empty() ? "" : beside + " has no effect on a mechanism; omit this option";
}

class MechanismAlongPath : public PathKind
{
public:
  MechanismAlongPath(std::unique_ptr<MechanismTouch> touch, const Mechanism& mechanism)
    : touch_(std::move(touch)), mechanism_(mechanism)
  {
  }

  [[nodiscard]] std::vector<PathColumn> columns() const override
  {
    std::vector<PathColumn> columns{ { "Turn", 4 }, { "Torque", 3 }, { "Residual", 1 } };
    for (const MechanismConstraint& law : this->mechanism_.laws)
    {
      columns.insert(columns.end(),
        { { "Force of " + law.name, 3 }, { "Phase of " + law.name, 1 }, { "Inside of " + law.name, 1 } });
    }
    return columns;
  }

  void next(const PathSample& sample, PathTick& tick) override
  {
    const MechanismPlan& plan = this->touch_->plan();
    const MechanismResult result = this->touch_->next(sample.time_s, sample.hand_W);
    this->pose_W_ = result.pose_W;
    tick.proxy_W = result.pose_W[plan.held];
    tick.wrench_W = result.wrench_W;
    tick.contacts = 0;
    const Quat& q = tick.proxy_W.q;
    const Vec3& torque = tick.wrench_W.torque;
    tick.more = { q.w(), q.x(), q.y(), q.z(), torque.x(), torque.y(), torque.z(), result.residual_u };
    for (int i = 0; i < plan.lawCount + result.found; ++i)
    {
      tick.contacts += result.laws[i].force_W.squaredNorm() > 0.0 ? 1 : 0;
    }
    for (int i = 0; i < plan.lawCount; ++i)
    {
      const ConstraintNow& law = result.laws[i];
      const Vec3& force = law.force_W;
      tick.more.insert(
        tick.more.end(), { force.x(), force.y(), force.z(), static_cast<double>(law.phase), law.inside_u });
    }
    this->capped_ += result.capped ? 1 : 0;
    this->ahead_ += result.ahead ? 1 : 0;
    this->crowded_ += this->touch_->bodies().found().leftOut > 0 ? 1 : 0;
    this->tellEvents(result, sample.time_s);
    this->tellOverlaps(sample.time_s);
  }

  void finish(PathReport& report) const override
  {
    noteTicks(report, this->capped_, "the constraints were not satisfied within a tick's work");
    noteTicks(
      report, this->ahead_, "the hand was faster than contacts are looked for, so that the held mesh stayed behind");
    noteTicks(
      report, this->crowded_, "the held mesh touched in more places than a tick can solve; the nearest were kept");
    for (const auto& [a, b] : this->touch_->begunIn())
    {
      report.notes.push_back(
        "the path begins with bodies \"" + a + "\" and \"" + b + "\" in one another: they are pushed apart");
    }
    report.notes.insert(report.notes.end(), this->overlaps_.begin(), this->overlaps_.end());
    report.remarks.insert(report.remarks.end(), this->events_.begin(), this->events_.end());
  }

protected:
  [[nodiscard]] const MechanismTouch& touch() const noexcept { return *this->touch_; }
  /// Of a body in the last tick.
  [[nodiscard]] const Pose& pose_W(std::size_t body) const noexcept { return this->pose_W_[body]; }

private:
  void tellEvents(const MechanismResult& result, double time_s)
  {
    for (int i = 0; i < result.eventCount; ++i)
    {
      const MechanismEvent& event = result.events[i];
      std::ostringstream text;
      text << time_s << " s: " << this->mechanism_.laws[event.law].name << ' ' << wordsOf(event.change) << " at "
           << event.force_N << " N";
      this->events_.push_back(text.str());
    }
  }

  /// Each pair when it begins to overlap.
  void tellOverlaps(double time_s)
  {
    const std::vector<BodyPair>& now = this->touch_->overlaps();
    for (const BodyPair& pair : now)
    {
      if (std::ranges::find(this->before_, pair) == this->before_.end())
      {
        std::ostringstream text;
        text << time_s << " s: " << overlapText(pair);
        this->overlaps_.push_back(text.str());
      }
    }
    this->before_ = now;
  }

  std::unique_ptr<MechanismTouch> touch_;
  Mechanism mechanism_;
  decltype(MechanismResult::pose_W) pose_W_{};
  std::vector<BodyPair> before_;
  std::vector<std::string> events_;
  std::vector<std::string> overlaps_;
  int capped_ = 0; ///< ticks, as those below
  int ahead_ = 0;
  int crowded_ = 0;
};

/// A tool or a ball among a soft body and loose ones, with the columns of a tool and the places of the loose ones.
class HandAmongBodiesAlongPath final : public MechanismAlongPath
{
public:
  HandAmongBodiesAlongPath(std::unique_ptr<MechanismTouch> touch, const MechanismInputs& inputs)
    : MechanismAlongPath(std::move(touch), inputs.mechanism), bodyName_(inputs.soft.empty() ? "" : inputs.soft[0].name)
  {
    for (std::size_t b = 0; b < inputs.mechanism.bodies.size(); ++b)
    {
      if (isLoose(inputs.mechanism.bodies[b]))
      {
        this->loose_.push_back({ inputs.mechanism.bodies[b].name, b });
      }
    }
  }

  [[nodiscard]] std::vector<PathColumn> columns() const override
  {
    std::vector<PathColumn> columns{ { "Turn", 4 }, { "Torque", 3 }, { "Angle", 1 } };
    for (const auto& [name, body] : this->loose_)
    {
      columns.insert(columns.end(), { { "Place of " + name, 3 }, { "Turn of " + name, 4 } });
    }
    return columns;
  }

  [[nodiscard]] const BodyMaker* body() const override
  {
    return this->bodyName_.empty() ? nullptr : &this->touch().bodies().maker(0);
  }

  void next(const PathSample& sample, PathTick& tick) override
  {
    constexpr double degreesPerRadian = 180.0 / std::numbers::pi;
    MechanismAlongPath::next(sample, tick);
    tick.more.back() = degreesPerRadian * sample.hand_W.q.angularDistance(tick.proxy_W.q); // in place of the residual
    for (const auto& [name, body] : this->loose_)
    {
      const auto& [p, q] = this->pose_W(body);
      tick.more.insert(tick.more.end(), { p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z() });
    }
  }

  void finish(PathReport& report) const override
  {
    MechanismAlongPath::finish(report);
    if (this->body() && this->body()->wentThroughItself())
    {
      report.notes.push_back(this->bodyName_ + ": " + throughItselfText);
    }
  }

private:
  std::string bodyName_; ///< of the soft one; "": there is none
  std::vector<std::pair<std::string, std::size_t>> loose_;
};

/// "a tool that presses a soft body", "a hand among loose bodies".
std::string handOf(const PathInputs& inputs)
{
  return inputs.tool && inputs.body ? "a tool that presses a soft body" : "a hand among loose bodies";
}

/// Such a hand feels bodies: any other input would be lost.
std::string lostAmongBodies(const PathInputs& inputs)
{
  const std::string ball = inputs.tool ? "" : "Radius";
  const std::string lost = setBeside(inputs.settings,
    { "Stiffness", "Scale", "FrictionStatic", "FrictionKinetic", "ToolLever", "MechanismTurning", "SoftRate", ball });
  const std::string hand = handOf(inputs);
  return !lost.empty()  ? lost + " has no effect on " + hand + "; omit this option"
         : inputs.field ? inputs.field->name + ": " + hand + " feels no field; omit this input"
                        : "";
}

LooseSources looseOf(const PathInputs& inputs)
{
  LooseSources loose;
  loose.unit_m = inputs.body ? inputs.body->input->unit_m : 1.0 / inputs.settings.number("Scale");
  for (const PathSurface& each : inputs.surfaces)
  {
    if (each.density_kg_per_m3 != 0.0)
    {
      loose.density_kg_per_m3[each.name] = each.density_kg_per_m3;
    }
  }
  return loose;
}

/// The surfaces that the hand and a soft body touch; fewer with a refusal.
std::vector<MechanismBody> surfacesBeside(const PathInputs& inputs, const LooseSources& loose, PathReport& report)
{
  const auto scene = inputs.surfaces.empty() ? nullptr : pathScene(inputs, report);
  SurfacesBeside beside;
  (void)beside.follow(scene.get(), "", loose);
  if (report.refusal.empty() && !beside.reason().empty())
  {
    const std::string way = beside.refusedLoose()        ? "be loose"
                            : inputs.tool && inputs.body ? "be touched by a tool on a soft body"
                                                         : "be touched by a hand among loose bodies";
    report.refusal = beside.refused() + ": cannot " + way + ": " + beside.reason() + "; omit this input" +
                     (loose.density_kg_per_m3.empty() ? ", or touch the soft body without a tool" : "");
  }
  return beside.bodies();
}

/// As the metric of a tool has it: its lever is that of the tool about the hand, or of a ball that stays upright
/// (BallMesh.h), unless one is set.
MechanismHold mechanismHoldOf(const ToolHold& hold, double own_u, double lowRate_Hz)
{
  const double arm_m = hold.characteristic_u.value_or(own_u) / hold.scale_u_per_m;
  return { hold.stiffness_N_per_m, hold.stiffness_N_per_m * arm_m * arm_m, hold.scale_u_per_m, lowRate_Hz };
}

/// The mesh in the hand, and the lever that it has by itself [u].
struct InHand
{
  std::string name;
  std::shared_ptr<const TriangleMesh> mesh_H;
  double lever_u = 0.0;
};

/// A mesh that cannot be a tool on surfaces is none among bodies either.
Outcome<InHand> inHand(const PathInputs& inputs)
{
  if (!inputs.tool)
  {
    const double radius_u = inputs.settings.number("Radius");
    return { { "ball", std::make_shared<const TriangleMesh>(ballMesh(radius_u)), ballLever_u(radius_u) },
      radius_u > 0.0 ? "" : "{Radius}: a point cannot push a loose body; set a radius above 0, or add a tool" };
  }
  const Outcome<ToolMesh> tool = makeTool(*inputs.tool->mesh, Vec3(Vec3::Zero()));
  return { { inputs.tool->name, inputs.tool->mesh, tool.value.gyration_u },
    tool.ok() ? "" : inputs.tool->name + ": cannot be held: " + tool.problem };
}

} // namespace

std::unique_ptr<PathKind> handAmongBodiesAlongPath(const PathInputs& inputs, PathReport& report)
{
  const ToolHold hold = toolHoldOf(inputs.settings);
  report.refusal = lostAmongBodies(inputs);
  report.refusal = report.refusal.empty() ? refuseHold(hold) : report.refusal;
  if (!report.refusal.empty())
  {
    return nullptr;
  }
  const LooseSources loose = looseOf(inputs);
  const std::vector<MechanismBody> beside = surfacesBeside(inputs, loose, report);
  const Outcome<InHand> held = report.refusal.empty() ? inHand(inputs) : Outcome<InHand>{};
  report.refusal += held.problem;
  if (!report.refusal.empty())
  {
    return nullptr;
  }
  const MechanismSoftInput body =
    inputs.body ? MechanismSoftInput{ inputs.body->name, inputs.body->input } : MechanismSoftInput{};
  const auto made = toolOnBody(held.value.name, *held.value.mesh_H, body, hold.friction, beside, loose.unit_m);
  if (!made.ok())
  {
    report.refusal = held.value.name + ": cannot be held: " + made.problem;
    return nullptr;
  }
  const double asked_Hz = inputs.settings.number("SoftRate");
  const double rate_Hz = inputs.body || asked_Hz == 0.0 ? asked_Hz : std::max(asked_Hz, leastLooseRate_Hz);
  auto touch = MechanismTouch::make(*made.value, mechanismHoldOf(hold, held.value.lever_u, rate_Hz), report.refusal);
  report.refusal =
    withUnitTaken(report.refusal, *made.value, "choose the unit of lengths by {Scale}, which is 1000 for millimetres");
  const std::string left = touch && inputs.body ? touch->bodies().maker(0).checked().report.summary() : "";
  if (!left.empty())
  {
    report.notes.push_back(inputs.body->name + ": " + left);
  }
  return touch ? std::make_unique<HandAmongBodiesAlongPath>(std::move(touch), *made.value) : nullptr;
}

std::unique_ptr<PathKind> mechanismAlongPath(const PathInputs& inputs, PathReport& report)
{
  report.refusal = lostBesideMechanism(inputs);
  if (!report.refusal.empty())
  {
    return nullptr;
  }
  const PathMechanism& mechanism = *inputs.mechanism;
  auto touch = MechanismTouch::make(*mechanism.inputs, mechanismHoldOf(inputs.settings), report.refusal);
  if (!touch)
  {
    report.refusal = mechanism.name + ": " + report.refusal;
    return nullptr;
  }
  return touch->plan().wire ? wireAlongPath(std::move(touch))
                            : std::make_unique<MechanismAlongPath>(std::move(touch), mechanism.inputs->mechanism);
}

} // namespace palpate
