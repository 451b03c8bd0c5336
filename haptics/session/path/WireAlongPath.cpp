// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/wire/WireTick.h"
#include "haptics/session/path/PathKind.h"

namespace palpate
{
namespace
{

/// Of the hand that holds the wire, in units of the scene.
struct WireHold
{
  double coupling_N_per_u = 0.0;
  double turning_Nu_per_rad = 0.0;
  double scale_u_per_m = 1.0;
};

WireHold holdOf(const SettingStore& settings)
{
  const double scale_u_per_m = settings.number("Scale");
  return { settings.number("Stiffness") / scale_u_per_m, settings.number("MechanismTurning") * scale_u_per_m,
    scale_u_per_m };
}

std::string lostBesideWire(const PathInputs& inputs)
{
  const std::string lost = setBeside(inputs.settings, { "Stiffness", "Scale", "MechanismTurning" });
  return lost.empty() ? "" : lost + " has no effect on a wire; omit this option";
}

class WireAlongPath final : public PathKind
{
public:
  WireAlongPath(const PlannedWire& planned, const WireHold& hold) : planned_(planned), hold_(hold) {}

  [[nodiscard]] std::vector<PathColumn> columns() const override
  {
    return { { "Torque", 3 }, { "Pushed", 1 }, { "Turned", 1 }, { "Tip Force", 1 }, { "Wall Force", 1 },
      { "Wall Place", 3 }, { "Residual", 1 } };
  }

  void next(const PathSample& sample, PathTick& tick) override
  {
    WireInput input;
    input.plan = this->planned_.plan.get();
    input.hand_W = sample.hand_W;
    input.coupling_N_per_u = this->hold_.coupling_N_per_u;
    input.turning_Nu_per_rad = this->hold_.turning_Nu_per_rad;
    const WireResult& result = this->tick_.step(input);
    tick.proxy_W = { result.tip_W, input.plan->mouth_W.q };
    tick.wrench_W = result.wrench_W;
    tick.wrench_W.torque /= this->hold_.scale_u_per_m;
    tick.contacts = result.pressCount;
    const Vec3 &torque = tick.wrench_W.torque, &wall = result.wall_W;
    tick.more = { torque.x(), torque.y(), torque.z(), result.pushed_u, result.turned_rad, result.tip_N, result.wall_N,
      wall.x(), wall.y(), wall.z(), result.residual_u };
    this->capped_ += result.capped ? 1 : 0;
    this->leftOut_ += result.leftOut > 0 ? 1 : 0;
    this->crowded_ += result.crowded > 0 ? 1 : 0;
  }

  void finish(PathReport& report) const override
  {
    noteTicks(report, this->capped_, "the wire was not at rest within a tick's steps");
    noteTicks(report, this->leftOut_, "the wire touched in more places than a tick can solve; the nearest were kept");
    noteTicks(report, this->crowded_,
      "more triangles were around a beam of the wire than are looked at; give the vessel fewer triangles");
    report.remarks.insert(
      report.remarks.end(), this->planned_.check.remarks.begin(), this->planned_.check.remarks.end());
  }

private:
  PlannedWire planned_;
  WireHold hold_;
  WireTick tick_;
  int capped_ = 0; ///< ticks, as those below
  int leftOut_ = 0;
  int crowded_ = 0;
};

} // namespace

std::unique_ptr<PathKind> wireAlongPath(const PathInputs& inputs, PathReport& report)
{
  report.refusal = lostBesideWire(inputs);
  const WireHold hold = holdOf(inputs.settings);
  if (report.refusal.empty() && !(hold.coupling_N_per_u > 0.0))
  {
    report.refusal = "the stiffness that a wire is held with must be above 0";
  }
  if (!report.refusal.empty())
  {
    return nullptr;
  }
  const PlannedWire planned = planWire(inputs.wire->description, *inputs.wire->vessel_W, 1);
  if (!planned.plan)
  {
    report.refusal = inputs.wire->name + ": " + planned.check.faults.front();
    return nullptr;
  }
  return std::make_unique<WireAlongPath>(planned, hold);
}

} // namespace palpate
