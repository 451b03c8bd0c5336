// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>
#include <sstream>

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
  std::vector<BodyPair> before_;
  std::vector<std::string> events_;
  std::vector<std::string> overlaps_;
  int capped_ = 0; ///< ticks, as those below
  int ahead_ = 0;
  int crowded_ = 0;
};

/// A mesh in the hand on one soft body, with the columns of a tool.
class ToolOnBodyAlongPath final : public MechanismAlongPath
{
public:
  ToolOnBodyAlongPath(std::unique_ptr<MechanismTouch> touch, const MechanismInputs& inputs)
    : MechanismAlongPath(std::move(touch), inputs.mechanism), bodyName_(inputs.soft.front().name)
  {
  }

  [[nodiscard]] std::vector<PathColumn> columns() const override
  {
    return { { "Turn", 4 }, { "Torque", 3 }, { "Angle", 1 } };
  }

  [[nodiscard]] const BodyMaker* body() const override { return &this->touch().bodies().maker(0); }

  void next(const PathSample& sample, PathTick& tick) override
  {
    constexpr double degreesPerRadian = 180.0 / std::numbers::pi;
    MechanismAlongPath::next(sample, tick);
    tick.more.back() = degreesPerRadian * sample.hand_W.q.angularDistance(tick.proxy_W.q); // in place of the residual
  }

  void finish(PathReport& report) const override
  {
    MechanismAlongPath::finish(report);
    if (this->body()->wentThroughItself())
    {
      report.notes.push_back(this->bodyName_ + ": " + throughItselfText);
    }
  }

private:
  std::string bodyName_;
};

constexpr const char* withoutTool = "; omit this input, or touch the soft body without a tool";

/// A tool that presses a soft body feels that body and surfaces: any other input would be lost.
std::string lostBesideToolOnBody(const PathInputs& inputs)
{
  const std::string lost = setBeside(inputs.settings,
    { "Stiffness", "Scale", "FrictionStatic", "FrictionKinetic", "ToolLever", "MechanismTurning", "SoftRate" });
  return !lost.empty()  ? lost + " has no effect on a tool that presses a soft body; omit this option"
         : inputs.field ? inputs.field->name + ": a tool that presses a soft body feels no field" + withoutTool
                        : "";
}

/// The surfaces that tool and soft body touch; fewer with a refusal.
std::vector<MechanismBody> surfacesBeside(const PathInputs& inputs, PathReport& report)
{
  const auto scene = inputs.surfaces.empty() ? nullptr : pathScene(inputs, report);
  SurfacesBeside beside;
  (void)beside.follow(scene.get(), "");
  if (report.refusal.empty() && !beside.reason().empty())
  {
    report.refusal =
      beside.refused() + ": cannot be touched by a tool on a soft body: " + beside.reason() + withoutTool;
  }
  return beside.bodies();
}

/// As the metric of a tool has it: its lever is that of the tool about the hand, unless one is set.
MechanismHold mechanismHoldOf(const ToolHold& hold, const ToolMesh& tool, double lowRate_Hz)
{
  const double arm_m = hold.characteristic_u.value_or(tool.gyration_u) / hold.scale_u_per_m;
  return { hold.stiffness_N_per_m, hold.stiffness_N_per_m * arm_m * arm_m, hold.scale_u_per_m, lowRate_Hz };
}

} // namespace

/// A mesh that cannot be a tool on surfaces is none on a soft body either.
std::unique_ptr<PathKind> toolOnBodyAlongPath(const PathInputs& inputs, PathReport& report)
{
  const ToolHold hold = toolHoldOf(inputs.settings);
  report.refusal = lostBesideToolOnBody(inputs);
  report.refusal = report.refusal.empty() ? refuseHold(hold) : report.refusal;
  if (!report.refusal.empty())
  {
    return nullptr;
  }
  const std::vector<MechanismBody> beside = surfacesBeside(inputs, report);
  if (!report.refusal.empty())
  {
    return nullptr;
  }
  const Outcome<ToolMesh> tool = makeTool(*inputs.tool->mesh, Vec3(Vec3::Zero()));
  const auto made =
    toolOnBody(inputs.tool->name, *inputs.tool->mesh, { inputs.body->name, inputs.body->input }, hold.friction, beside);
  report.refusal = !tool.ok() ? tool.problem : made.problem;
  if (!report.refusal.empty())
  {
    report.refusal = inputs.tool->name + ": cannot be held: " + report.refusal;
    return nullptr;
  }
  auto touch = MechanismTouch::make(
    *made.value, mechanismHoldOf(hold, tool.value, inputs.settings.number("SoftRate")), report.refusal);
  const std::string left = touch ? touch->bodies().maker(0).checked().report.summary() : "";
  if (!left.empty())
  {
    report.notes.push_back(inputs.body->name + ": " + left);
  }
  return touch ? std::make_unique<ToolOnBodyAlongPath>(std::move(touch), *made.value) : nullptr;
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
