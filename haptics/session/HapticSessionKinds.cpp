// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <utility>

#include "haptics/force/StabilityLimits.h"
#include "haptics/session/SessionInputs.h"
#include "haptics/session/SessionRun.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/mechanism/BallMesh.h"
#include "haptics/session/mechanism/MechanismTouch.h"
#include "haptics/session/mechanism/PressingTool.h"
#include "haptics/tool/servo/FrictionTarget.h"

// The choices that workers compute: tool, soft body, mechanism.

namespace palpate
{

HapticSession::Chosen::Chosen() : pressing(std::make_unique<PressingTool>()) {}
HapticSession::Chosen::~Chosen() = default;

const SessionWorkers* HapticSession::workers() const noexcept
{
  return this->run_ ? this->run_->workers.get() : nullptr;
}

/// A tool that is to press stays in the hand until its mechanism is computed.
ToolChoice HapticSession::heldTool() const
{
  return !this->chosen_->pressing->isPair() || this->toolPresses() ? this->chosen<ToolTask>() : ToolChoice{};
}

void HapticSession::pairTool()
{
  const double friction = std::min(this->parameters_.contact.friction.kinetic, largestToolFriction);
  const double ball_u = this->parameters_.contact.radius_u;
  this->chosen_->pressing->follow({ this->chosen<ToolTask>(), this->chosen<SoftTask>(), this->chosen_->loose, friction,
    ball_u, this->scene().get() });
}

void HapticSession::setLoose(const LooseSources& loose)
{
  const Holding before = this->holding();
  this->chosen_->loose = loose;
  this->pairTool();
  this->followChoice(before != this->holding());
}

const std::string& HapticSession::looseRefusal() const
{
  return this->chosen_->pressing->looseRefusal();
}

bool HapticSession::putBack()
{
  const bool felt = this->toolPresses() && this->chosen_->pressing->beginAgain();
  this->followChoice(false);
  return felt;
}

HapticSession::Holding HapticSession::holding() const
{
  return { this->toolBesideSoft().empty(), this->toolPresses() };
}

/// A ball that is a mesh among loose bodies is felt to turn about its middle; else no ball is.
double HapticSession::heldLever_u() const
{
  const double ball_u = this->toolPresses() ? this->chosen_->pressing->ball_u() : 0.0;
  return ball_u > 0.0 ? ball_u : this->heldTool().weighs_u();
}

/// The hand turns a tool that presses by the metric of tools, whatever torque the device has, and keeps a ball upright.
void HapticSession::adapt(Run& run, bool first) const
{
  run.adapt(this->parameters_, this->characteristic_u(), first);
  if (this->toolPresses())
  {
    const double ball_u = this->chosen_->pressing->ball_u();
    const double lever_u = ball_u > 0.0 ? ballLever_u(ball_u) : this->heldTool().weighs_u();
    const double lever_m = lever_u / this->parameters_.map.scale_u_per_m;
    run.adapted.mechanismTurning_N_m_per_rad = this->parameters_.stiffness_N_per_m * lever_m * lever_m;
  }
}

void HapticSession::followChoice(bool handChanges)
{
  if (this->run_)
  {
    if (handChanges)
    {
      this->adapt(*this->run_, false);
      this->run_->links.parameters.write({ ++this->version_, this->run_->adapted });
    }
    this->orderWork(*this->run_);
  }
}

/// Workers whose order is the same as before do not notice.
void HapticSession::orderWork(Run& run) const
{
  SessionTasks::Choices choices = *this->chosen_;
  std::get<ToolChoice>(choices) = this->heldTool();
  if (this->toolPresses())
  {
    std::get<SoftChoice>(choices) = {};
    std::get<MechanismChoice>(choices) = this->chosen_->pressing->made();
  }
  run.workers->order(choices, { this->scene(), this->parameters_.known, this->grip(run.adapted), run.period_s });
}

std::string HapticSession::refuseMechanism(
  const MechanismInputs& inputs, const std::vector<std::shared_ptr<const PressedBody>>& atRest) const
{
  std::vector<MechanismSoft> soft;
  for (std::size_t b = 0; b < std::min(inputs.soft.size(), atRest.size()); ++b)
  {
    soft.push_back({ inputs.soft[b].name, atRest[b].get() });
  }
  const MechanismGrip grip = this->grip(this->run_ ? this->run_->adapted : this->parameters_);
  return faultsOf(checkMechanism(inputs.mechanism, soft, grip));
}

/// Of the tool or mechanism in the hand; 0: nothing is turned.
double HapticSession::characteristic_u() const noexcept
{
  const HapticParameters& p = this->parameters_;
  const double mechanism_m = mechanismLever_m(p.mechanismTurning_N_m_per_rad, p.stiffness_N_per_m);
  const double mechanism_u = this->chosen<MechanismTask>().inputs ? mechanism_m * p.map.scale_u_per_m : 0.0;
  return std::max(mechanism_u, this->heldLever_u()); // a tool is in the hand until the mechanism is computed
}

/// As the tick would have it without limits.
MechanismGrip HapticSession::grip(const HapticParameters& adapted) const noexcept
{
  const double scale_u_per_m = this->parameters_.map.scale_u_per_m;
  return { this->parameters_.stiffness_N_per_m / scale_u_per_m, adapted.mechanismTurning_N_m_per_rad * scale_u_per_m };
}

std::string HapticSession::toolBesideSoft() const
{
  return this->chosen_->pressing->refusal();
}

bool HapticSession::toolPresses() const
{
  return this->chosen_->pressing->made().inputs && !this->chosen<MechanismTask>().inputs;
}

std::shared_ptr<const MechanismInputs> HapticSession::feltMechanism() const
{
  return this->toolPresses() ? this->chosen_->pressing->made().inputs : this->chosen<MechanismTask>().inputs;
}

std::string HapticSession::toolRefusal() const
{
  const std::string beside = this->toolBesideSoft();
  const bool presses = this->toolPresses();
  return !beside.empty() ? beside : presses ? this->status<MechanismTask>().problem : this->status<ToolTask>().problem;
}

const ToolReport& HapticSession::toolReport()
{
  if (this->run_)
  {
    this->kept_->toolReport = this->run_->links.tool.report.read();
  }
  return this->kept_->toolReport;
}

} // namespace palpate
