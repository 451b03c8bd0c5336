// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh in the hand in place of the ball.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "haptics/geometry/measure/ContactPlace.h"
#include "vtkHapticSessionInternals.h"

bool vtkHapticSession::AddTool(const char* name, vtkDataObject* data)
{
  this->HoldTool(this->Impl->Tool.Take(name ? name : "", data));
  return this->Impl->Tool.Choice().tool || !data;
}

void vtkHapticSession::HoldTool(const std::string& problem)
{
  this->Impl->Core.setTool(this->Impl->Tool.Choice());
  const std::string beside = this->Impl->Core.toolBesideSoft();
  this->Refuse(problem.empty() ? beside : problem);
  this->Impl->Follow("tool", problem.empty() ? beside : problem);
  this->Impl->JudgeStability();
  this->Impl->Tool.Follow(this->Impl->Core, this->Impl->State);
  this->Impl->Scene.follow(this->Impl->PlanNow());
}

void vtkHapticSession::GetToolShape(vtkPolyData* shape) const
{
  vtkPolyData* const ofMechanism = this->Impl->Mechanism.HeldShape();
  ofMechanism ? shape->ShallowCopy(ofMechanism) : this->Impl->Tool.GetShape(shape);
}

double vtkHapticSession::GetToolReach(const double direction_W[3]) const
{
  const auto& tool = this->Impl->Tool.Choice().tool;
  const palpate::Quat turn_W = this->Impl->State.tool.hand_W.q;
  const palpate::Vec3 direction = turn_W.conjugate() * palpate::Vec3(direction_W);
  double reach_u = 0.0;
  if (tool)
  {
    for (const palpate::Vec3& v : tool->shape_B->mesh().vertices_W)
    {
      reach_u = std::max(reach_u, -direction.dot(v));
    }
  }
  return reach_u;
}

void vtkHapticSession::SetToolSource(const char* name)
{
  const std::string source = name ? name : "";
  if (source != this->Impl->Tool.Source)
  {
    this->Impl->Tool.Source = source;
    this->AddTool(nullptr, nullptr);
    this->Impl->MaterialTime.Modified(); // who follows a view adds its surfaces again, all but this one
    this->Modified();
  }
}

const char* vtkHapticSession::GetToolSource() const
{
  return this->Impl->Tool.Source.c_str();
}

template<class Value>
void vtkHapticSession::Internals::ChangeTool(vtkHapticSession* session, const char* setting,
  std::initializer_list<double> numbers, Value& held, const Value& value, bool anew)
{
  if (session->Allows(setting, numbers) && held != value)
  {
    held = value;
    vtkHapticHeldTool& tool = session->Impl->Tool;
    session->HoldTool(anew ? tool.TakeAgain() : tool.TakeLever());
    session->Modified();
  }
}

void vtkHapticSession::SetToolHandle(int choice)
{
  Internals::ChangeTool(this, "ToolHandle", { static_cast<double>(choice) }, this->Impl->Tool.Handle,
    static_cast<vtkHapticToolHandle>(choice), true);
}

int vtkHapticSession::GetToolHandle() const
{
  return static_cast<int>(this->Impl->Tool.Handle);
}

void vtkHapticSession::SetToolHandlePoint(double x, double y, double z)
{
  vtkHapticHeldTool& tool = this->Impl->Tool;
  Internals::ChangeTool(this, "ToolHandlePoint", { x, y, z }, tool.HandlePoint_T, palpate::Vec3(x, y, z),
    tool.Handle == vtkHapticToolHandle::Handle);
}

double* vtkHapticSession::GetToolHandlePoint()
{
  return this->Impl->Tool.HandlePoint_T.data();
}

void vtkHapticSession::SetToolTipPoint(double x, double y, double z)
{
  Internals::ChangeTool(this, "ToolTipPoint", { x, y, z }, this->Impl->Tool.TipPoint_T, palpate::Vec3(x, y, z), false);
}

double* vtkHapticSession::GetToolTipPoint()
{
  return this->Impl->Tool.TipPoint_T.data();
}

void vtkHapticSession::SetToolLever(double lever_u)
{
  Internals::ChangeTool(this, "ToolLever", { lever_u }, this->Impl->Tool.Lever_u, lever_u, false);
}

double vtkHapticSession::GetToolLever() const
{
  return this->Impl->Tool.Lever_u;
}

void vtkHapticSession::SetHandTurn(double w, double x, double y, double z)
{
  const palpate::Quat turn(w, x, y, z);
  const double length = turn.norm();
  const bool usable = length > 0.0 && turn.coeffs().allFinite();
  const std::string problem =
    usable ? "" : "the turn of the hand must be a quaternion (w, x, y, z) that is not of length 0";
  this->Refuse(problem);
  this->Impl->Follow("hand's turn", problem);
  this->Impl->HandTurn_W = usable ? turn.normalized() : this->Impl->HandTurn_W;
  this->Impl->Feed();
}

const char* vtkHapticSession::GetToolText() const
{
  return this->Impl->Tool.Text.c_str();
}

std::optional<palpate::ContactPlace> vtkHapticSession::Internals::PlaceOfContact() const
{
  const palpate::ToolState& tool = this->State.tool;
  const palpate::Scene& scene = *this->Scene.built().scene;
  if (!tool.held)
  {
    return palpate::placeOf(scene, this->State.proxy_W.p, this->State.device_W.p);
  }
  const auto* const end = tool.presses.begin() + tool.active;
  const auto* const most = std::max_element(
    tool.presses.begin(), end, [](const auto& one, const auto& other) { return one.push_u < other.push_u; });
  return most == end ? std::nullopt : palpate::placeOf(scene, most->p_W, most->p_W - most->n_W);
}

const char* vtkHapticSession::GetToolContacts() const
{
  Internals& impl = *this->Impl;
  const palpate::ToolState& tool = impl.State.tool;
  double all_u = 0.0;
  for (int i = 0; i < tool.active; ++i)
  {
    all_u += tool.presses[i].push_u;
  }
  std::ostringstream lines;
  lines.precision(4);
  for (int i = 0; i < tool.active && all_u > 0.0 && impl.Scene.built().scene; ++i)
  {
    const palpate::ToolPress& press = tool.presses[i];
    const auto place = palpate::placeOf(*impl.Scene.built().scene, press.p_W, press.p_W - press.n_W);
    lines << (place ? place->surface : "?") << " at (" << press.p_W.x() << ", " << press.p_W.y() << ", "
          << press.p_W.z() << ") u, " << std::lround(100.0 * press.push_u / all_u) << " %\n";
  }
  impl.Tool.Contacts = lines.str();
  return impl.Tool.Contacts.c_str();
}

double* vtkHapticSession::GetToolPose()
{
  return this->Impl->Mechanism.HeldShape() ? this->Impl->Mechanism.Pose : this->Impl->Tool.Pose;
}

double* vtkHapticSession::GetToolHandPose()
{
  return this->Impl->Mechanism.HeldShape() ? this->Impl->Mechanism.HandPose : this->Impl->Tool.HandPose;
}

double* vtkHapticSession::GetToolTip()
{
  return this->Impl->Tool.Tip;
}

double* vtkHapticSession::GetToolTorque()
{
  return this->Impl->Tool.Asked;
}

double* vtkHapticSession::GetTorque()
{
  return this->Impl->Tool.Given;
}
