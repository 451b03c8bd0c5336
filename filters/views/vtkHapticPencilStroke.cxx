// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPencilStroke.h"

#include "haptics/geometry/curves/CurveSimplification.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <cmath>
#include <optional>

using palpate::Vec3;

namespace
{
constexpr double spacing_px = 2.0;
constexpr double edgeOn = 1e-3; ///< of the ray's length, as far as it goes across the plane

Vec3 Unprojected(vtkRenderer* renderer, double x, double y, double z)
{
  double p[4];
  renderer->SetDisplayPoint(x, y, z);
  renderer->DisplayToWorld();
  renderer->GetWorldPoint(p);
  return Vec3(Vec3(p) / p[3]);
}

std::optional<Vec3> OnPlane(vtkRenderer* renderer, double x, double y, const Vec3& origin_W, const Vec3& normal_W)
{
  const Vec3 near_W = Unprojected(renderer, x, y, 0.0);
  const Vec3 ray = Unprojected(renderer, x, y, 1.0) - near_W;
  const double across = normal_W.dot(ray);
  const double share = normal_W.dot(origin_W - near_W) / across;
  if (std::fabs(across) < edgeOn * ray.norm() || !(share >= 0.0))
  {
    return std::nullopt;
  }
  Vec3 p_W = near_W + share * ray;
  for (int k = 0; k < 3; ++k)
  {
    // A plane across an axis is met to the bit: curves drawn at one height lie at one height.
    p_W[k] = std::fabs(normal_W[k]) == 1.0 ? origin_W[k] : p_W[k];
  }
  return p_W;
}
} // namespace

vtkHapticPencilStroke::vtkHapticPencilStroke(const Vec3& point_W, const Vec3& normal_W)
  : Origin_W(point_W), Normal_W(normal_W)
{
}

vtkHapticPencilStroke vtkHapticPencilStroke::OnScreen(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  return { Vec3(camera->GetFocalPoint()), Vec3(camera->GetDirectionOfProjection()) };
}

bool vtkHapticPencilStroke::Add(vtkRenderer* renderer, double x, double y)
{
  const bool first = this->Points_W.empty();
  if (!first && std::hypot(x - this->LastX, y - this->LastY) < spacing_px)
  {
    return false;
  }
  const std::optional<Vec3> p_W = OnPlane(renderer, x, y, this->Origin_W, this->Normal_W);
  if (!p_W)
  {
    return false;
  }
  if (first)
  {
    const std::optional<Vec3> next_W = OnPlane(renderer, x + 1.0, y, this->Origin_W, this->Normal_W);
    this->Pixel_u = next_W ? (*next_W - *p_W).norm() : 0.0;
  }
  this->Points_W.push_back(*p_W);
  this->LastX = x;
  this->LastY = y;
  return true;
}

void vtkHapticPencilStroke::Simplify()
{
  std::vector<Vec3> kept_W;
  for (const std::uint32_t index : palpate::simplify(this->Points_W, this->Pixel_u).kept)
  {
    kept_W.push_back(this->Points_W[index]);
  }
  this->Points_W = std::move(kept_W);
}
