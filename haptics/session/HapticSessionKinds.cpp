// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "haptics/force/StabilityLimits.h"
#include "haptics/session/SessionInputs.h"
#include "haptics/session/SessionRun.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/mechanism/MechanismTouch.h"

// The choices that workers compute: tool, soft body, mechanism.

namespace palpate
{

const SessionWorkers* HapticSession::workers() const noexcept
{
  return this->run_ ? this->run_->workers.get() : nullptr;
}

ToolChoice HapticSession::heldTool() const
{
  return this->toolBesideSoft().empty() ? this->chosen<ToolTask>() : ToolChoice{};
}

void HapticSession::followChoice(bool handChanges)
{
  if (this->run_)
  {
    if (handChanges)
    {
      this->run_->adapt(this->parameters_, this->characteristic_u(), false);
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
  const std::shared_ptr<const ToolMesh>& tool = this->chosen<ToolTask>().tool;
  const bool refused = this->chosen<SoftTask>().input && tool && !(tool->ball_u() > 0.0);
  return refused ? "a tool cannot touch a soft body: release the tool, or remove the soft body" : "";
}

std::string HapticSession::toolRefusal() const
{
  const std::string beside = this->toolBesideSoft();
  return beside.empty() ? this->status<ToolTask>().problem : beside;
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
