// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "haptics/force/StabilityLimits.h"
#include "haptics/session/SessionInputs.h"
#include "haptics/session/SessionKept.h"
#include "haptics/session/SessionRun.h"
#include "haptics/session/mechanism/MechanismTouch.h"
#include "haptics/session/mechanism/MechanismWorker.h"
#include "haptics/session/soft/SoftWorker.h"
#include "haptics/session/tool/ToolWorker.h"

// What the hand holds and what gives way: tool, soft body, mechanism.

namespace palpate
{

const ToolChoice& HapticSession::tool() const noexcept
{
  return this->kept_->tool;
}

const SoftChoice& HapticSession::soft() const noexcept
{
  return this->kept_->soft;
}

const MechanismChoice& HapticSession::mechanism() const noexcept
{
  return this->kept_->mechanism;
}

ToolChoice HapticSession::heldTool() const
{
  return this->toolBesideSoft().empty() ? this->kept_->tool : ToolChoice{};
}

void HapticSession::setTool(const ToolChoice& choice)
{
  this->kept_->tool = choice;
  this->takeTool();
}

void HapticSession::takeTool()
{
  if (this->run_)
  {
    this->run_->tool->setTool(this->heldTool());
    this->run_->adapt(this->parameters_, this->lever_u(), false);
    this->run_->links.parameters.write({ ++this->version_, this->run_->adapted });
  }
}

void HapticSession::setSoft(const SoftChoice& choice)
{
  const bool otherHand = this->kept_->tool.tool && !this->kept_->soft.input != !choice.input;
  this->kept_->soft = choice;
  if (otherHand)
  {
    this->takeTool();
  }
  if (this->run_)
  {
    this->run_->soft->setBody(choice);
  }
}

SoftStatus HapticSession::softStatus() const
{
  return this->run_ ? this->run_->soft->status() : SoftStatus{};
}

void HapticSession::setMechanism(const MechanismChoice& choice)
{
  this->kept_->mechanism = choice;
  if (this->run_)
  {
    this->run_->mechanism->setMechanism(choice, this->grip(this->run_->adapted));
    this->run_->adapt(this->parameters_, this->lever_u(), false);
    this->run_->links.parameters.write({ ++this->version_, this->run_->adapted });
  }
}

MechanismStatus HapticSession::mechanismStatus() const
{
  return this->run_ ? this->run_->mechanism->status() : MechanismStatus{};
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

/// Of what is in the hand; 0: nothing is turned.
double HapticSession::lever_u() const noexcept
{
  const HapticParameters& p = this->parameters_;
  const double mechanism_m = mechanismLever_m(p.mechanismTurning_N_m_per_rad, p.stiffness_N_per_m);
  const double mechanism_u = this->kept_->mechanism.inputs ? mechanism_m * p.map.scale_u_per_m : 0.0;
  return std::max(mechanism_u, this->heldTool().weighs_u()); // a tool is in the hand until the mechanism is computed
}

/// As the tick would have it without limits.
MechanismGrip HapticSession::grip(const HapticParameters& adapted) const noexcept
{
  const double scale_u_per_m = this->parameters_.map.scale_u_per_m;
  return { this->parameters_.stiffness_N_per_m / scale_u_per_m, adapted.mechanismTurning_N_m_per_rad * scale_u_per_m };
}

std::string HapticSession::toolBesideSoft() const
{
  const bool refused = this->kept_->soft.input && this->kept_->tool.tool && !(this->kept_->tool.tool->ball_u() > 0.0);
  return refused ? "a tool cannot touch a soft body: release the tool, or remove the soft body" : "";
}

std::string HapticSession::toolRefusal() const
{
  const std::string beside = this->toolBesideSoft();
  return beside.empty() && this->run_ ? this->run_->tool->status().refusal : beside;
}

std::string HapticSession::toolNoWayOut() const
{
  return this->run_ ? this->run_->tool->status().noWayOut : std::string();
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
