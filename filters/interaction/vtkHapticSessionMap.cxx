// SPDX-License-Identifier: GPL-3.0-or-later
// How the workspace of the device lies in the scene.
#include <algorithm>

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
  double bounds[6];
  if (!this->GetSceneBounds(bounds))
  {
    this->Refuse("there is no scene to fit the workspace to; add a surface and commit it");
    return;
  }
  const Vec3 low_W(bounds[0], bounds[2], bounds[4]);
  const Vec3 high_W(bounds[1], bounds[3], bounds[5]);
  const double radius_m = this->Impl->InfoNow().workspaceRadius_m.value;
  const double half = 0.5 * (high_W - low_W).norm();
  this->Change(
    [&](palpate::HapticParameters& p)
    {
      p.map.scale_u_per_m = half / radius_m;
      p.map.offset_W = 0.5 * (low_W + high_W);
      if (this->Impl->Scene.built().plane_WP && this->Impl->InfoNow().abilities.sensedAxes == 2)
      {
        p.map.q_WD = this->Impl->Scene.built().plane_WP->q; // a device that moves in a plane moves in this one
      }
    });
  this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
}
