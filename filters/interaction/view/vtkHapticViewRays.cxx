// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticViewRays.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

using palpate::Vec3;

vtkHapticRay vtkHapticViewRays::At(double x, double y) const
{
  const auto unproject = [this, x, y](double z)
  {
    double p[4];
    this->Renderer->SetDisplayPoint(x, y, z);
    this->Renderer->DisplayToWorld();
    this->Renderer->GetWorldPoint(p);
    return Vec3(Vec3(p) / p[3]);
  };
  return { unproject(0.0), unproject(1.0) };
}

vtkHapticRay vtkHapticViewRays::Through(const Vec3& p_W) const
{
  double display[3];
  this->Renderer->SetWorldPoint(p_W.x(), p_W.y(), p_W.z(), 1.0);
  this->Renderer->WorldToDisplay();
  this->Renderer->GetDisplayPoint(display);
  return this->At(display[0], display[1]);
}

/// From where a point is seen. Without perspective that is infinitely far away: so far that little comes behind it.
Vec3 vtkHapticViewRays::EyeOn(const Vec3& p_W) const
{
  constexpr double farAway = 10.0;
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const Vec3 eye_W(camera->GetPosition());
  const double distance = (p_W - eye_W).norm() + 2.0 * camera->GetParallelScale();
  return camera->GetParallelProjection() ? Vec3(p_W - farAway * distance * Vec3(camera->GetDirectionOfProjection()))
                                         : eye_W;
}

/// Along the direction of projection, from the eye [u].
double vtkHapticViewRays::DepthOf(const Vec3& p_W) const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  return (p_W - Vec3(camera->GetPosition())).dot(Vec3(camera->GetDirectionOfProjection()));
}

Vec3 vtkHapticViewRays::AtDepth(const vtkHapticRay& ray, double depth) const
{
  const double nearest = this->DepthOf(ray.Near);
  return ray.Near + (depth - nearest) / (this->DepthOf(ray.Far) - nearest) * (ray.Far - ray.Near);
}
