// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticHeldTool.h"

#include <optional>

#include "haptics/session/settings/Setting.h"
#include "vtkHapticConversion.h"

std::string vtkHapticHeldTool::Take(const std::string& name, vtkDataObject* data)
{
  this->Name = name;
  const vtkHapticConversionResult made = data ? vtkHapticToMesh(data) : vtkHapticConversionResult();
  this->Mesh = made.Mesh;
  if (data && !made.Mesh)
  {
    this->Choice_ = {};
    this->Shape = nullptr;
    this->Problem = name + " cannot be held: " + made.Problem;
    return this->Problem;
  }
  return this->Make();
}

std::string vtkHapticHeldTool::TakeAgain()
{
  return this->Mesh ? this->Make() : std::string();
}

std::string vtkHapticHeldTool::Make()
{
  this->Choice_ = {};
  this->Problem.clear();
  if (this->Mesh)
  {
    const std::optional<palpate::Vec3> handle =
      this->AtOrigin ? std::optional<palpate::Vec3>(palpate::Vec3::Zero()) : std::nullopt;
    const palpate::ToolResult made = palpate::makeTool(*this->Mesh, handle);
    this->Problem = made.ok() ? "" : this->Name + " cannot be held: " + made.refusal;
    this->Choice_.tool = made.ok() ? std::make_shared<const palpate::ToolMesh>(made.tool) : nullptr;
    this->Choice_.lever_u = this->Lever_u;
  }
  this->Shape = this->Choice_.tool ? vtkHapticToPolyData(*this->Mesh) : nullptr;
  return this->Problem;
}

void vtkHapticHeldTool::GetShape(vtkPolyData* shape) const
{
  this->Shape ? shape->ShallowCopy(this->Shape) : shape->Initialize();
}

/// A pose of the core is that of the tool's centre.
void vtkHapticHeldTool::PutPose(const palpate::Pose& centre_W, double pose[7]) const
{
  const palpate::Vec3 centre = this->Choice_.tool ? this->Choice_.tool->centre_W : palpate::Vec3::Zero();
  Eigen::Map<palpate::Vec3>{ pose } = centre_W.p - centre_W.q * centre;
  const double turn[] = { centre_W.q.w(), centre_W.q.x(), centre_W.q.y(), centre_W.q.z() };
  std::copy(turn, turn + 4, pose + 3);
}

void vtkHapticHeldTool::Follow(palpate::HapticSession& core, const palpate::HapticState& state)
{
  const palpate::WorkspaceMap& map = core.parameters().map;
  this->PutPose(state.tool.held ? state.proxy_W : palpate::Pose{}, this->Pose);
  this->PutPose(state.tool.hand_W, this->HandPose);
  Eigen::Map<palpate::Vec3>{ this->Asked } = map.directionToScene(state.renderedTorque_D);
  Eigen::Map<palpate::Vec3>{ this->Given } = map.directionToScene(state.torque_D);
  this->Text = this->Source.empty() ? "" : this->Sentence(core, state);
}

std::string vtkHapticHeldTool::Sentence(palpate::HapticSession& core, const palpate::HapticState& state) const
{
  if (!this->Problem.empty())
  {
    return this->Problem;
  }
  if (!this->Choice_.tool)
  {
    return this->Source + " is not there: choose another source as the tool, or none";
  }
  const std::string refusal = core.toolRefusal();
  if (!refusal.empty())
  {
    return refusal;
  }
  const std::size_t triangles = this->Choice_.tool->shape_B->mesh().triangles.size();
  std::string text = this->Name + ", " + std::to_string(triangles) + " triangles";
  if (!state.tool.held || !core.running())
  {
    return text;
  }
  if (!state.tool.placed)
  {
    return text + ", waits: it meets the scene where the hand is; move the hand to where it is free";
  }
  const double lever_u = state.tool.lever_m * core.parameters().map.scale_u_per_m;
  text += ", lever " + palpate::quantity(lever_u, "u") + ", " + std::to_string(state.contacts) + " contacts push";
  return state.clamped && state.contacts > 0
           ? text + "; the hand is outside what fits, further than the force may say: lead it back to the tool"
           : text;
}
