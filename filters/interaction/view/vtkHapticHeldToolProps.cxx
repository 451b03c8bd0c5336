// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticHeldToolProps.h"

#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkMath.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

namespace
{
constexpr double ghostOpacity = 0.25;
constexpr double InFront = -4.0; // of the same triangles, in steps of the depth buffer

/// Of a place and a turn (w, x, y, z).
void SetFrame(vtkMatrix4x4* frame, const double pose[7])
{
  double turn[3][3];
  vtkMath::QuaternionToMatrix3x3(pose + 3, turn);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      frame->SetElement(row, column, turn[row][column]);
    }
    frame->SetElement(row, 3, pose[row]);
  }
}
} // namespace

vtkHapticHeldToolProps::vtkHapticHeldToolProps()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(this->Shape);
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(
    InFront, InFront); // a mechanism is drawn as a whole, too
  this->Solid->SetMapper(mapper);
  this->Ghost->SetMapper(mapper);
  this->Solid->SetUserMatrix(this->SolidFrame);
  this->Ghost->SetUserMatrix(this->GhostFrame);
  this->Solid->GetProperty()->SetColor(1.0, 0.75, 0.1);
  this->Ghost->GetProperty()->SetColor(0.15, 0.45, 1.0);
  this->Ghost->GetProperty()->SetOpacity(ghostOpacity);
}

bool vtkHapticHeldToolProps::UpdateFrom(vtkHapticSession* session)
{
  vtkNew<vtkPolyData> now;
  session->GetSight()->GetToolShape(now);
  const bool held = now->GetNumberOfPolys() > 0;
  if (now->GetPolys() != this->Shape->GetPolys()) // the mapper draws the same as long as it can
  {
    this->Shape->ShallowCopy(now);
  }
  this->Solid->SetVisibility(held);
  this->Ghost->SetVisibility(held);
  SetFrame(this->SolidFrame, session->GetToolPose());
  SetFrame(this->GhostFrame, session->GetToolHandPose());
  return held;
}
