// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPressedBody.h"

#include "haptics/session/HapticSession.h"
#include <sstream>

#include "haptics/session/SessionWorkers.h"
#include "haptics/session/settings/Setting.h"

namespace
{
constexpr double CountEvery_s = 1.0;

std::string Rounded(double value, int digits)
{
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

/// Of a body that a tool presses.
palpate::SoftStatus StatusOf(const palpate::MechanismStatus& made)
{
  palpate::SoftStatus status;
  static_cast<palpate::WorkStatus&>(status) = made;
  if (!made.soft.empty())
  {
    status.shape = made.soft.front().shape;
    status.asMade = made.soft.front().asMade;
  }
  return status;
}
} // namespace

void vtkHapticPressedBody::Choose(palpate::HapticSession& core) const
{
  core.choose<palpate::SoftTask>({ this->Input, this->Name, this->Rate_Hz });
}

std::string vtkHapticPressedBody::Convert(vtkDataObject* data, const std::string& /*reason*/)
{
  const vtkHapticSoftBodyResult read = data ? vtkHapticToSoftBody(data) : vtkHapticSoftBodyResult();
  this->Input = read.Input;
  this->Material = read.Input ? vtkHapticSoftBodyText(*read.Input) : "";
  this->Shown = nullptr;
  return data && !read.Input ? this->Name + " cannot be a soft body: " + read.Problem : "";
}

void vtkHapticPressedBody::CountPackets(double now_s)
{
  if (this->Status.snapshots < this->CountedPackets) // of another body
  {
    this->CountedPackets = 0;
    this->Counted_s = now_s;
  }
  if (now_s - this->Counted_s >= CountEvery_s)
  {
    this->PacketsPerSecond =
      static_cast<double>(this->Status.snapshots - this->CountedPackets) / (now_s - this->Counted_s);
    this->CountedPackets = this->Status.snapshots;
    this->Counted_s = now_s;
  }
}

void vtkHapticPressedBody::Look(palpate::HapticSession& core, const palpate::HapticState& state, double now_s)
{
  const bool byTool = core.toolPresses();
  this->Status = byTool ? StatusOf(core.status<palpate::MechanismTask>()) : core.status<palpate::SoftTask>();
  this->Pressed = byTool ? state.mechanism.touching > 0 : state.soft.pressed;
  this->IsFelt = byTool ? state.mechanism.held : state.soft.felt;
  this->Age_s = byTool ? state.mechanism.age_s : state.soft.age_s;
  this->CountPackets(now_s);
  this->Hand_W = this->Status.shape ? this->Status.shape->hand_W : state.device_W.p;
  const double radius_u = state.tool.ball_u > 0.0 ? state.tool.ball_u : core.parameters().contact.radius_u;
  this->Ball = { state.proxy_W.p, state.soft.pressed ? radius_u : 0.0 };
  this->Strain = this->Status.shape ? this->Status.shape->mostGradient : 0.0;
}

const char* vtkHapticPressedBody::Absent() const
{
  return " does not exist: choose another source as the soft body, or none";
}

std::string vtkHapticPressedBody::Sentence(
  palpate::HapticSession& /*core*/, const palpate::HapticState& /*state*/) const
{
  const std::string text = this->Name + ": " + this->Material;
  if (!this->Status.problem.empty())
  {
    return text + ". The body is rigid: " + this->Status.problem;
  }
  if (!this->Status.shape)
  {
    return text + (this->Status.building ? "; is being computed; rigid until then" : "");
  }
  return text + "; " + Rounded(this->PacketsPerSecond, 3) + " solves per second, " +
         (this->IsFelt ? palpate::quantity(1e3 * this->Age_s, "ms") + " old" : "not used yet") + ", largest strain " +
         vtkHapticStrainText(*this->Status.shape) +
         (this->Pressed && this->Status.shape->struck
             ? "; hit faster than a body of " + palpate::quantity(this->Input->density_kg_per_m3, "kg/m3") +
                 " could respond; inertia is not modelled"
             : "") +
         (this->Pressed && this->Status.shape->throughItself_u > 0.0 ? std::string("; ") + palpate::throughItselfText
                                                                     : "");
}

bool vtkHapticPressedBody::Bend(vtkUnstructuredGrid& body)
{
  if (!this->Input || this->Status.shape == this->Shown)
  {
    return false;
  }
  this->Shown = this->Status.shape;
  vtkHapticBendBody(body, *this->Input, this->Status.asMade.get(), this->Shown.get(), this->Ball);
  return true;
}
