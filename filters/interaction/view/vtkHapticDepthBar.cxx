// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticDepthBar.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double middle_px = 20.0; ///< from the left edge of the view
constexpr double barHalf_px = 2.0, handleHalf_px = 8.0;
constexpr double lowShare = 0.25, heightShare = 0.5; ///< of the view

/// A rectangle whose corners are `corners`, which are placed later.
void Draw(vtkActor2D* actor, vtkPoints* corners, const double colour[3])
{
  constexpr vtkIdType all = 4;
  corners->SetNumberOfPoints(all);
  vtkNew<vtkCellArray> faces;
  const vtkIdType face[all] = { 0, 1, 2, 3 };
  faces->InsertNextCell(all, face);
  vtkNew<vtkPolyData> rectangle;
  rectangle->SetPoints(corners);
  rectangle->SetPolys(faces);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(rectangle);
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->PickableOff();
  actor->VisibilityOff();
}

void PlaceAround(vtkPoints* corners, double low_px, double high_px, double half_px)
{
  corners->SetPoint(0, middle_px - half_px, low_px, 0.0);
  corners->SetPoint(1, middle_px + half_px, low_px, 0.0);
  corners->SetPoint(2, middle_px + half_px, high_px, 0.0);
  corners->SetPoint(3, middle_px - half_px, high_px, 0.0);
  corners->Modified();
}
} // namespace

vtkHapticDepthBar::vtkHapticDepthBar()
{
  const double grey[3] = { 0.6, 0.6, 0.6 };
  const double blue[3] = { 0.15, 0.45, 1.0 }; // of the hand
  Draw(this->Bar, this->BarCorners, grey);
  Draw(this->Handle, this->HandleCorners, blue);
}

vtkHapticDepthBar::~vtkHapticDepthBar()
{
  this->SetRenderer(nullptr);
}

void vtkHapticDepthBar::SetRenderer(vtkRenderer* renderer)
{
  for (vtkActor2D* const actor : { this->Bar.Get(), this->Handle.Get() })
  {
    actor->VisibilityOff();
    if (this->Renderer)
    {
      this->Renderer->RemoveViewProp(actor);
    }
    if (renderer)
    {
      renderer->AddViewProp(actor);
    }
  }
  this->Renderer = renderer;
}

double vtkHapticDepthBar::Low() const
{
  return lowShare * this->Renderer->GetSize()[1];
}

double vtkHapticDepthBar::Height() const
{
  return heightShare * this->Renderer->GetSize()[1];
}

void vtkHapticDepthBar::Show(double share)
{
  if (!this->Renderer)
  {
    return;
  }
  const double at_px = this->Low() + std::clamp(share, 0.0, 1.0) * this->Height();
  PlaceAround(this->BarCorners, this->Low(), this->Low() + this->Height(), barHalf_px);
  PlaceAround(this->HandleCorners, at_px - handleHalf_px, at_px + handleHalf_px, handleHalf_px);
  this->Bar->VisibilityOn();
  this->Handle->VisibilityOn();
}

void vtkHapticDepthBar::Hide()
{
  this->Bar->VisibilityOff();
  this->Handle->VisibilityOff();
}

bool vtkHapticDepthBar::IsAt(double x_px, double y_px) const
{
  if (!this->Renderer || this->Bar->GetVisibility() == 0)
  {
    return false;
  }
  const int* const origin = this->Renderer->GetOrigin();
  const double up_px = y_px - origin[1] - this->Low();
  return std::abs(x_px - origin[0] - middle_px) <= handleHalf_px && up_px >= -handleHalf_px &&
         up_px <= this->Height() + handleHalf_px;
}

double vtkHapticDepthBar::ShareAt(double y_px) const
{
  return this->Renderer && this->Height() > 0.0
           ? std::clamp((y_px - this->Renderer->GetOrigin()[1] - this->Low()) / this->Height(), 0.0, 1.0)
           : 0.0;
}
