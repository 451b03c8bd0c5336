// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/PressingTool.h"

#include <algorithm>
#include <utility>

#include "haptics/geometry/scene/Scene.h"
#include "haptics/mechanism/sided/SidedSurface.h"
#include "haptics/session/mechanism/BallMesh.h"
#include "haptics/session/mechanism/MechanismBodies.h"
#include "haptics/session/mechanism/ToolOnBody.h"

namespace palpate
{
namespace
{

constexpr double sizeOfPoint = 0.02; ///< of the loose surface's diagonal

/// The first surface of a scene that is to be loose; "": none is.
std::string firstLoose(const Scene* scene, const LooseSources& loose)
{
  if (!scene)
  {
    return "";
  }
  const auto first = std::ranges::find_if(
    scene->surfaces(), [&loose](const Surface& surface) { return loose.densityOf(surface.name) != nullptr; });
  return first != scene->surfaces().end() ? first->name : "";
}

} // namespace

PressingTool::Has PressingTool::wanted(const HandAmongBodies& around)
{
  const auto& [tool, soft, loose, friction, ball_u, scene] = around;
  Has has;
  has.loose = firstLoose(scene, loose);
  has.pair = tool.tool && soft.input && !(tool.tool->ball_u() > 0.0);
  if (has.pair || !has.loose.empty())
  {
    has.tool = tool.tool;
    has.body = soft.input;
    has.name = soft.input ? soft.name : "";
    has.both = soft.input && loose.densityOf(soft.name);
    has.friction = friction;
    has.ball_u = tool.tool ? 0.0 : ball_u;
    has.unit_m = soft.input ? soft.input->unit_m : loose.unit_m;
  }
  return has;
}

void PressingTool::follow(const HandAmongBodies& around)
{
  Has has = wanted(around);
  const bool any = has.pair || !has.loose.empty();
  LooseSources loose = around.loose;
  loose.unit_m = has.unit_m;
  const bool others = this->beside_.follow(any ? around.scene : nullptr, has.name, loose);
  if (!any || others || has != this->has_)
  {
    this->has_ = std::move(has);
    this->made_.inputs = nullptr;
    this->made_.name = this->has_.body ? this->has_.name : this->has_.loose;
    this->refusal_ = this->looseRefusal_ = "";
    if (any)
    {
      this->make();
    }
  }
  const bool solves = this->has_.body != nullptr;
  this->made_.rate_Hz = solves ? around.soft.rate_Hz : std::max(around.soft.rate_Hz, leastLooseRate_Hz);
}

bool PressingTool::beginAgain()
{
  if (this->made_.inputs)
  {
    this->made_.inputs = std::make_shared<const MechanismInputs>(*this->made_.inputs); // other inputs: another order
  }
  return this->made_.inputs != nullptr;
}

std::string PressingTool::whyNotBeside() const
{
  const std::string& refused = this->beside_.refused();
  return "a tool that presses a soft body cannot touch " + refused + ": " + this->beside_.reason() + "; hide " +
         refused + ", or release the tool to touch both with the proxy sphere";
}

std::string PressingTool::whyNotLoose() const
{
  const std::string& refused = this->beside_.refused();
  const bool isFull = this->beside_.bodies().size() == SurfacesBeside::most;
  const std::string why = ": " + this->beside_.reason() + "; it is touched as fixed now; ";
  return this->beside_.refusedLoose()
           ? refused + " cannot be loose" + why + (isFull ? "hide another source" : "repair or simplify its mesh")
           : this->has_.loose + " cannot be loose beside " + refused + why + "hide " + refused;
}

/// A mesh has a size, which a point has not.
double PressingTool::ballNow_u() const
{
  const auto& bodies = this->beside_.bodies();
  const auto loose = std::ranges::find_if(bodies, [](const MechanismBody& body) { return isLoose(body); });
  const double point_u = loose != bodies.end() ? sizeOfPoint * loose->mesh->diagonal_u : 0.0;
  return this->has_.tool ? 0.0 : this->has_.ball_u > 0.0 ? this->has_.ball_u : point_u;
}

void PressingTool::make()
{
  const bool loose = !this->has_.loose.empty();
  if (this->has_.both)
  {
    this->looseRefusal_ =
      this->has_.name + " cannot be loose: it is the soft body; touch it as one of the two, or touch another soft body";
    this->refusal_ = this->has_.pair ? this->looseRefusal_ : "";
    return;
  }
  if (loose && !(this->has_.unit_m > 0.0))
  {
    this->looseRefusal_ = this->has_.loose +
                          " cannot be loose: its mass needs the unit of lengths, which no file of the scene names; "
                          "choose the unit of lengths (SceneUnit)";
    this->refusal_ = this->has_.pair ? this->looseRefusal_ : "";
    return;
  }
  if (!this->beside_.reason().empty())
  {
    this->refusal_ = this->has_.pair ? this->whyNotBeside() : "";
    this->looseRefusal_ = loose ? this->whyNotLoose() : "";
    return;
  }
  this->ball_u_ = this->ballNow_u();
  auto made = toolOnBody(this->has_.tool ? "tool" : "ball",
    this->has_.tool ? this->has_.tool->shape_B->mesh() : ballMesh(this->ball_u_), { this->has_.name, this->has_.body },
    this->has_.friction, this->beside_.bodies(), this->has_.unit_m);
  this->made_.inputs = std::move(made.value);
  if (!made.ok())
  {
    const std::string remedy = "; hold another tool, or release it to ";
    this->refusal_ = this->has_.pair
                       ? "the tool cannot press a soft body: " + made.problem + remedy + "press with the proxy sphere"
                       : "";
    this->looseRefusal_ = loose ? "the tool cannot touch " + this->has_.loose + " as loose: " + made.problem + remedy +
                                    "touch with the proxy sphere"
                                : "";
  }
}

} // namespace palpate
