// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh in the hand in place of the ball.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "haptics/geometry/measure/ContactPlace.h"
#include "vtkHapticSessionInternals.h"
#include "vtkHapticTool.h"

bool vtkHapticSession::AddTool(const char* name, vtkDataObject* data)
{
  return this->Impl->AddFelt(this->Impl->Tool, name, data);
}

std::string vtkHapticSession::Internals::FollowToolHandle()
{
  const auto handle = static_cast<vtkHapticToolHandle>(this->Settings.whole("ToolHandle"));
  const palpate::Vec3 point_T(this->Settings.of("ToolHandlePoint").numbers.data());
  const bool moved = handle == vtkHapticToolHandle::Handle && point_T != this->Tool.HandlePoint_T;
  const bool anew = handle != this->Tool.Handle || moved;
  this->Tool.Handle = handle;
  this->Tool.HandlePoint_T = point_T;
  this->Tool.TipPoint_T = palpate::Vec3(this->Settings.of("ToolTipPoint").numbers.data());
  this->Tool.Lever_u = this->Settings.number("ToolLever");
  this->Feel(this->Tool, anew ? this->Tool.TakeAgain() : this->Tool.TakeLever());
  return {};
}

void vtkHapticSession::SetHandTurn(double w, double x, double y, double z)
{
  const palpate::Quat turn(w, x, y, z);
  const double length = turn.norm();
  const bool usable = length > 0.0 && turn.coeffs().allFinite();
  const std::string problem =
    usable ? "" : "the rotation of the hand must be a quaternion (w, x, y, z) of length above 0";
  this->Impl->Refuse(problem);
  this->Impl->Follow("hand's rotation", problem);
  this->Impl->HandTurn_W = usable ? turn.normalized() : this->Impl->HandTurn_W;
  this->Impl->Feed();
}

std::optional<palpate::ContactPlace> vtkHapticSession::Internals::PlaceOfContact(
  const palpate::HapticState& touched) const
{
  const palpate::ToolState& tool = touched.tool;
  const palpate::Scene& scene = *this->Scene.built().scene;
  if (!tool.held)
  {
    return palpate::placeOf(scene, touched.proxy_W.p, touched.device_W.p);
  }
  const auto* const end = tool.presses.begin() + tool.active;
  const auto* const most = std::max_element(
    tool.presses.begin(), end, [](const auto& one, const auto& other) { return one.push_u < other.push_u; });
  return most == end ? std::nullopt : palpate::placeOf(scene, most->p_W, most->p_W - most->n_W);
}

const char* vtkHapticSession::Internals::SayToolContacts()
{
  const palpate::ToolState& tool = this->State.tool;
  double all_u = 0.0;
  for (int i = 0; i < tool.active; ++i)
  {
    all_u += tool.presses[i].push_u;
  }
  std::ostringstream lines;
  lines.precision(4);
  for (int i = 0; i < tool.active && all_u > 0.0 && this->Scene.built().scene; ++i)
  {
    const palpate::ToolPress& press = tool.presses[i];
    const auto place = palpate::placeOf(*this->Scene.built().scene, press.p_W, press.p_W - press.n_W);
    lines << (place ? place->surface : "?") << " at (" << press.p_W.x() << ", " << press.p_W.y() << ", "
          << press.p_W.z() << ") u, " << std::lround(100.0 * press.push_u / all_u) << " %\n";
  }
  this->Tool.Contacts = lines.str();
  return this->Tool.Contacts.c_str();
}
