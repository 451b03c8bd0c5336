// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPencilStroke.h"

#include "haptics/geometry/curves/CurveSimplification.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <cmath>
#include <utility>

using palpate::Vec3;

namespace
{
constexpr double spacing_px = 2.0;
} // namespace

vtkHapticPencilStroke::vtkHapticPencilStroke(vtkHapticPencilGround ground) : Ground(std::move(ground)) {}

bool vtkHapticPencilStroke::Add(vtkRenderer* renderer, double x, double y)
{
  const bool first = this->Points_W.empty();
  if (!first && std::hypot(x - this->LastX, y - this->LastY) < spacing_px)
  {
    return false;
  }
  const std::optional<Vec3> p_W = this->Ground(x, y);
  if (!p_W)
  {
    return false;
  }
  if (first)
  {
    const Vec3 towards_W(renderer->GetActiveCamera()->GetDirectionOfProjection());
    const std::optional<Vec3> next_W = vtkHapticPlaneGround(renderer, *p_W, towards_W)(x + 1.0, y);
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
