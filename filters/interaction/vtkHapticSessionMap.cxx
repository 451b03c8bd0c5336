// SPDX-License-Identifier: GPL-3.0-or-later
// How the workspace of the device lies in the scene.
#include <algorithm>

#include "haptics/session/plan/FittedMap.h"
#include "vtkCommand.h"
#include "vtkHapticSessionInternals.h"

using palpate::Vec3;

void vtkHapticSession::SetScale(double scale_u_per_m)
{
  this->Change("Scale", { scale_u_per_m }, [=](palpate::HapticParameters& p) { p.map.scale_u_per_m = scale_u_per_m; });
}

double vtkHapticSession::GetScale() const
{
  return this->Impl->Parameters.map.scale_u_per_m;
}

void vtkHapticSession::SetRotation(double w, double x, double y, double z)
{
  const palpate::Quat q(w, x, y, z);
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

void vtkHapticSession::FitWorkspace()
{
  const palpate::BuiltScene& scene = this->Impl->Scene.built();
  if (!scene.scene)
  {
    this->Refuse("there is no scene to fit the workspace to; add a surface and commit it");
    return;
  }
  const palpate::WorkspaceMap fitted = palpate::fittedMap(this->Impl->Parameters.map, scene, this->Impl->InfoNow());
  this->Change([&](palpate::HapticParameters& p) { p.map = fitted; });
  this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
}
