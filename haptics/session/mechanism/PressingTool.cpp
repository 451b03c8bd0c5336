// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/PressingTool.h"

#include "haptics/session/mechanism/ToolOnBody.h"

namespace palpate
{

void PressingTool::follow(const ToolChoice& tool, const SoftChoice& soft, double friction, const Scene* scene)
{
  const bool pair = tool.tool && soft.input && !(tool.tool->ball_u() > 0.0);
  const bool others = this->beside_.follow(pair ? scene : nullptr, soft.name);
  const bool same = pair && !others && this->tool_ == tool.tool && this->body_ == soft.input &&
                    this->made_.name == soft.name && this->friction_ == friction;
  if (!same)
  {
    this->tool_ = pair ? tool.tool : nullptr;
    this->body_ = pair ? soft.input : nullptr;
    this->friction_ = friction;
    this->made_.inputs = nullptr;
    this->made_.name = soft.name;
    this->refusal_ = "";
    if (pair)
    {
      this->make(tool, soft);
    }
  }
  this->made_.rate_Hz = soft.rate_Hz;
}

void PressingTool::make(const ToolChoice& tool, const SoftChoice& soft)
{
  if (const std::string& refused = this->beside_.refused(); !this->beside_.reason().empty())
  {
    this->refusal_ = "a tool that presses a soft body cannot touch " + refused + ": " + this->beside_.reason() +
                     "; hide " + refused + ", or release the tool to touch both with the proxy sphere";
    return;
  }
  auto made =
    toolOnBody("tool", tool.tool->shape_B->mesh(), { soft.name, soft.input }, this->friction_, this->beside_.bodies());
  this->made_.inputs = std::move(made.value);
  this->refusal_ = made.ok() ? ""
                             : "the tool cannot press a soft body: " + made.problem +
                                 "; hold another tool, or release it to press with the proxy sphere";
}

} // namespace palpate
