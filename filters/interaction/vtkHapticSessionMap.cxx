// SPDX-License-Identifier: GPL-3.0-or-later
// How the workspace of the device lies in the scene.
#include <algorithm>

#include "haptics/session/plan/FittedMap.h"
#include "vtkCommand.h"
#include "vtkHapticSessionInternals.h"

using palpate::Vec3;

<<<<<<< HEAD
=======
void vtkHapticSession::SetScale(double scale_u_per_m)
{
  this->Impl->MapByHand = this->Impl->MapByHand || scale_u_per_m != this->GetScale();
  this->Change("Scale", { scale_u_per_m }, [=](palpate::HapticParameters& p) { p.map.scale_u_per_m = scale_u_per_m; });
}

double vtkHapticSession::GetScale() const
{
  return this->Impl->Parameters.map.scale_u_per_m;
}

void vtkHapticSession::SetRotation(double w, double x, double y, double z)
{
  const palpate::Quat q(w, x, y, z);
  const bool other = !this->Impl->Parameters.map.q_WD.coeffs().isApprox(q.normalized().coeffs());
  this->Impl->MapByHand = this->Impl->MapByHand || other;
  this->Change("Rotation", { w, x, y, z }, [&q](palpate::HapticParameters& p) { p.map.q_WD = q.normalized(); });
}

void vtkHapticSession::SetRotation(const double wxyz[4])
{
  this->SetRotation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

double* vtkHapticSession::GetRotation()
{
  const palpate::Quat& q = this->Impl->Parameters.map.q_WD;
  const double wxyz[4] = { q.w(), q.x(), q.y(), q.z() };
  std::copy(wxyz, wxyz + 4, this->Impl->Rotation);
  return this->Impl->Rotation;
}

void vtkHapticSession::SetOffset(double x, double y, double z)
{
  this->Impl->MapByHand = this->Impl->MapByHand || this->Impl->Parameters.map.offset_W != Vec3(x, y, z);
  this->Change("Offset", { x, y, z }, [=](palpate::HapticParameters& p) { p.map.offset_W = Vec3(x, y, z); });
}

void vtkHapticSession::SetOffset(const double offset_W[3])
{
  this->SetOffset(offset_W[0], offset_W[1], offset_W[2]);
}

double* vtkHapticSession::GetOffset()
{
  Eigen::Map<Vec3>(this->Impl->Offset) = this->Impl->Parameters.map.offset_W;
  return this->Impl->Offset;
}

>>>>>>> home
void vtkHapticSession::FitWorkspace()
{
  Internals& impl = *this->Impl;
  impl.FitAsked = impl.Scene.worker().building();
  const bool nothing = !impl.FitAsked && !impl.Scene.built().scene;
  const std::string problem = nothing ? "there is nothing to fit the hand to: show a surface that can be touched" : "";
  this->Refuse(problem);
  impl.Follow("FitWorkspace", problem);
  if (!nothing && !impl.FitAsked)
  {
    this->Fit();
  }
}

void vtkHapticSession::Fit()
{
  Internals& impl = *this->Impl;
  impl.FitAsked = false;
  const palpate::WorkspaceMap fitted = palpate::fittedMap(impl.Parameters.map, impl.Scene.built(), impl.InfoNow());
  this->Change([&](palpate::HapticParameters& p) { p.map = fitted; });
  this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
}

void vtkHapticSession::SetFitOnTouch(bool on)
{
  if (on != this->Impl->FitOnTouch)
  {
    this->Impl->FitOnTouch = on;
    this->Modified();
  }
}

bool vtkHapticSession::GetFitOnTouch() const
{
  return this->Impl->FitOnTouch;
}
