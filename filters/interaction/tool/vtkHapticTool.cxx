// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticTool.h"

#include "haptics/session/HapticSession.h"
#include <optional>

#include "haptics/session/SessionWorkers.h"
#include "haptics/session/settings/Setting.h"
#include "haptics/tool/servo/FrictionTarget.h"
#include "vtkHapticConversion.h"

namespace
{
std::string ContactsText(double lever_u, int contacts)
{
  return ", lever " + palpate::quantity(lever_u, "u") + ", " + std::to_string(contacts) +
         (contacts == 1 ? " contact" : " contacts");
}

/// "", or that the force does not grow any more.
std::string TooFarText(const palpate::HapticState& state)
{
  return state.clamped && state.contacts > 0
           ? "; the hand is further from the tool than the largest force allows: move the hand back to the tool"
           : "";
}
} // namespace

void vtkHapticTool::Choose(palpate::HapticSession& core) const
{
  core.choose<palpate::ToolTask>(this->Chosen);
}

std::string vtkHapticTool::Refusal(const palpate::HapticSession& core) const
{
  return core.toolBesideSoft();
}

std::string vtkHapticTool::Convert(vtkDataObject* data, const std::string& /*reason*/)
{
  const vtkHapticConversionResult made = data ? vtkHapticToMesh(data) : vtkHapticConversionResult();
  this->Mesh = made.Mesh;
  if (data && !made.Mesh)
  {
    this->Chosen = {};
    this->Shape = nullptr;
    return this->Name + " cannot be held: " + made.Problem;
  }
  return this->Make();
}

std::string vtkHapticTool::TakeAgain()
{
  return this->Mesh ? this->Make() : std::string();
}

std::string vtkHapticTool::TakeLever()
{
  if (this->Chosen.tool)
  {
    this->Chosen.characteristic_u = this->LeverNow_u();
  }
  return this->Problem;
}

double vtkHapticTool::LeverNow_u() const
{
  return this->Lever_u == 0.0 && this->Handle == vtkHapticToolHandle::Handle
           ? (this->TipPoint_T - this->HandlePoint_T).norm()
           : this->Lever_u;
}

std::string vtkHapticTool::Make()
{
  this->Chosen = {};
  const std::string refusal = this->Mesh ? this->MakeTool() : std::string();
  this->Problem = refusal.empty() ? "" : this->Name + " cannot be held: " + refusal;
  this->Shape = this->Chosen.tool ? vtkHapticToPolyData(*this->Mesh) : nullptr;
  return this->Problem;
}

std::string vtkHapticTool::MakeTool()
{
  const bool atHandle = this->Handle == vtkHapticToolHandle::Handle;
  std::optional<palpate::Vec3> handle_T;
  if (this->Handle != vtkHapticToolHandle::Centre)
  {
    handle_T = atHandle ? this->HandlePoint_T : palpate::Vec3::Zero();
  }
  const auto made = palpate::makeTool(*this->Mesh, handle_T);
  if (made.ok())
  {
    this->Chosen.tool = std::make_shared<const palpate::ToolMesh>(made.value);
    this->Chosen.characteristic_u = this->LeverNow_u();
  }
  return made.problem;
}

void vtkHapticTool::GetShape(vtkPolyData* shape) const
{
  this->Shape ? shape->ShallowCopy(this->Shape) : shape->Initialize();
}

std::optional<vtkHapticHeldAxis> vtkHapticTool::Axis() const
{
  constexpr double inTheHand = 0.05; // of the diagonal: the middle is as good as the hand
  if (!this->Chosen.tool)
  {
    return std::nullopt;
  }
  const bool hasTip = this->Handle == vtkHapticToolHandle::Handle && this->TipPoint_T != this->HandlePoint_T;
  Eigen::AlignedBox3d box;
  for (const palpate::Vec3& v : this->Chosen.tool->shape_B->mesh().vertices_W)
  {
    box.extend(v);
  }
  const palpate::Vec3 tip_B = hasTip ? palpate::Vec3(this->TipPoint_T - this->HandlePoint_T) : box.center();
  if (tip_B.norm() > inTheHand * this->Chosen.tool->diagonal_u)
  {
    return vtkHapticHeldAxis{ tip_B, tip_B.normalized() };
  }
  Eigen::Index longest = 0;
  box.sizes().maxCoeff(&longest);
  return vtkHapticHeldAxis{ tip_B, -palpate::Vec3::Unit(longest) };
}

void vtkHapticPutPose(const palpate::Pose& from, double pose[7])
{
  Eigen::Map<palpate::Vec3>{ pose } = from.p;
  const double turn[] = { from.q.w(), from.q.x(), from.q.y(), from.q.z() };
  std::copy(turn, turn + 4, pose + 3);
}

/// A pose of the core is that of the tool's centre.
void vtkHapticTool::PutPose(const palpate::Pose& centre_W, double pose[7]) const
{
  const palpate::Vec3 centre = this->Chosen.tool ? this->Chosen.tool->centre_W : palpate::Vec3::Zero();
  vtkHapticPutPose({ centre_W.p - centre_W.q * centre, centre_W.q }, pose);
}

void vtkHapticTool::Look(palpate::HapticSession& core, const palpate::HapticState& state, double /*now_s*/)
{
  const palpate::WorkspaceMap& map = core.parameters().map;
  const bool presses = core.toolPresses() && state.mechanism.held;
  this->PutPose(state.tool.held || presses ? state.proxy_W : palpate::Pose{}, this->Pose);
  this->PutPose(presses ? state.mechanism.hand_W : state.tool.hand_W, this->HandPose);
  const Eigen::Map<const Eigen::Vector4d> turn(this->Pose + 3); // w, x, y, z
  Eigen::Map<palpate::Vec3>{ this->Tip } =
    Eigen::Map<const palpate::Vec3>(this->Pose) + palpate::Quat(turn[0], turn[1], turn[2], turn[3]) * this->TipPoint_T;
  Eigen::Map<palpate::Vec3>{ this->Asked } = map.directionToScene(state.renderedTorque_D);
  Eigen::Map<palpate::Vec3>{ this->Given } = map.directionToScene(state.torque_D);
}

const char* vtkHapticTool::Absent() const
{
  return " does not exist: choose another source as the tool, or none";
}

std::string vtkHapticTool::Sentence(palpate::HapticSession& core, const palpate::HapticState& state) const
{
  const std::string refusal = core.toolRefusal();
  if (!refusal.empty())
  {
    return refusal;
  }
  const std::size_t triangles = this->Chosen.tool->shape_B->mesh().triangles.size();
  std::string text = this->Name + ", " + std::to_string(triangles) + " triangles";
  if (core.toolPresses() && core.running())
  {
    return text + this->PressingText(core, state);
  }
  const std::string felt = palpate::describeFelt(*this->Chosen.tool, state.tool.ball_u > 0.0);
  text += felt.empty() ? "" : ", " + felt;
  if (!state.tool.held || !core.running())
  {
    return text;
  }
  if (!state.tool.placed)
  {
    return text + ", waits: the tool overlaps the scene at the hand; move the hand to a free position";
  }
  if (const std::string noWayOut = core.status<palpate::ToolTask>().noWayOut; !noWayOut.empty())
  {
    return text + ", " + noWayOut + ", then hold the tool again";
  }
  text += ContactsText(state.tool.lever_m * core.parameters().map.scale_u_per_m, state.contacts);
  text += core.parameters().contact.friction.kinetic > palpate::largestToolFriction
            ? "; tool friction is limited to 1; the kinetic friction set for the session is higher"
            : "";
  return text + TooFarText(state);
}

/// On a soft body, as a mechanism.
std::string vtkHapticTool::PressingText(const palpate::HapticSession& core, const palpate::HapticState& state) const
{
  const palpate::MechanismNow& now = state.mechanism;
  const auto& body = core.chosen<palpate::SoftTask>();
  if (!now.held)
  {
    return ", " + (body.input ? body.name + " is" : "loose sources are") +
           " being computed; the tool feels all rigid until then";
  }
  return (body.input ? ", presses " + body.name : ", touches loose sources") +
         ContactsText(this->Chosen.weighs_u(), now.touching) +
         (now.ahead ? "; the hand is faster than contacts are looked for, so that the tool stays behind" : "") +
         (now.leftOut > 0 ? "; the tool touches in more places than a tick can solve" : "") + TooFarText(state);
}
