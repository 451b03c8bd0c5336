// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/PressingTool.h"

#include "haptics/session/mechanism/ToolOnBody.h"

namespace palpate
{

void PressingTool::follow(const ToolChoice& tool, const SoftChoice& soft, double friction)
{
  const bool pair = tool.tool && soft.input && !(tool.tool->ball_u() > 0.0);
  const bool same = pair && this->tool_ == tool.tool && this->body_ == soft.input && this->made_.name == soft.name &&
                    this->friction_ == friction;
  if (!same)
  {
    this->tool_ = pair ? tool.tool : nullptr;
    this->body_ = pair ? soft.input : nullptr;
    this->friction_ = friction;
    const auto made = pair ? toolOnBody("tool", tool.tool->shape_B->mesh(), { soft.name, soft.input }, friction)
                           : Outcome<std::shared_ptr<const MechanismInputs>>{};
    this->made_.inputs = made.value;
    this->made_.name = soft.name;
    this->refusal_ = made.ok() ? ""
                               : "the tool cannot press a soft body: " + made.problem +
                                   "; hold another tool, or release it to press with the proxy sphere";
  }
  this->made_.rate_Hz = soft.rate_Hz;
}

} // namespace palpate
