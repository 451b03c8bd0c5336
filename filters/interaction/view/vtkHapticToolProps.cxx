// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticToolProps.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "vtkActor.h"
#include "vtkArrowSource.h"
#include "vtkCellArray.h"
#include "vtkHapticContactProps.h"
#include "vtkHapticHeldToolProps.h"
#include "vtkHapticLabyrinthGame.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkWeakPointer.h"

vtkStandardNewMacro(vtkHapticToolProps);

namespace
{
constexpr int ballResolution = 32;
constexpr int arrowResolution = 24;
/// The hand is drawn smaller than the proxy, so that both are seen when they are at one place.
constexpr double handShare = 0.75;
constexpr double softHandShare = 0.5; ///< likewise the hand that a soft body was computed for
constexpr float traceWidth = 3.0f;    // pixels
constexpr double torqueArm_m = 0.03;  // a torque is drawn as the force that has it at such an arm
constexpr double markOpacity = 0.4;   // a hand or proxy at start or exit shows through

/// 0 without a scene.
double DiagonalOf(vtkHapticSession* session)
{
  double b[6];
  return session->GetSceneBounds(b) ? std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]) : 0.0;
}

/// Columns: an orthogonal frame whose first axis is `along`, all of `length`; then the place.
void SetFrame(vtkMatrix4x4* matrix, const double along[3], double length, const double place[3])
{
  double axis[3][3];
  std::copy(along, along + 3, axis[0]);
  vtkMath::Normalize(axis[0]);
  vtkMath::Perpendiculars(axis[0], axis[1], axis[2], 0.0);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix->SetElement(row, column, length * axis[column][row]);
    }
    matrix->SetElement(row, 3, place[row]);
  }
}

/// Of a vector at a place; none of no length.
void PlaceArrow(vtkActor* arrow, vtkMatrix4x4* frame, const double vector[3], double scale, const double place[3])
{
  const double length = scale * vtkMath::Norm(vector);
  arrow->SetVisibility(length > 0.0);
  if (length > 0.0)
  {
    SetFrame(frame, vector, length, place);
  }
}
} // namespace

class vtkHapticToolProps::Internals
{
public:
  vtkNew<vtkActor> Proxy;
  vtkNew<vtkActor> Hand;
  vtkNew<vtkActor> SoftHand;
  vtkNew<vtkActor> Arrow;
  vtkNew<vtkActor> Trace;
  vtkNew<vtkActor> Start;
  vtkNew<vtkActor> Exit;
  vtkNew<vtkActor> Workspace;
  vtkNew<vtkActor> Field;
  vtkNew<vtkActor> Torque;
  vtkHapticHeldToolProps Held;
  vtkHapticContactProps Contacts;
  vtkNew<vtkPolyData> Box;
  vtkNew<vtkPolyData> Way;
  vtkNew<vtkPolyData> Shape; ///< of the field
  vtkNew<vtkMatrix4x4> ArrowFrame;
  vtkNew<vtkMatrix4x4> TorqueFrame;
  vtkWeakPointer<vtkRenderer> Renderer;

  Internals();
  vtkActor* const* begin() const { return this->All; }
  vtkActor* const* end() const { return this->All + 13; }
  void Place(vtkActor* actor, const double p_W[3], double radius) const;
  void PlaceMarks(vtkHapticSession* session, bool shown) const;
  void PlaceWorkspace(vtkHapticSession* session) const;

private:
  void MakeBox() const;

  vtkActor* All[13] = { this->Proxy, this->Hand, this->Arrow, this->Trace, this->Start, this->Exit, this->Workspace,
    this->Field, this->Torque, this->Held.Solid, this->Held.Ghost, this->Contacts.Arrows, this->SoftHand };
};

vtkHapticToolProps::Internals::Internals()
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1.0);
  ball->SetThetaResolution(ballResolution);
  ball->SetPhiResolution(ballResolution);
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(arrowResolution);
  arrow->SetShaftResolution(arrowResolution);
  vtkNew<vtkPolyDataMapper> ballMapper;
  ballMapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkPolyDataMapper> arrowMapper;
  arrowMapper->SetInputConnection(arrow->GetOutputPort());
  this->Proxy->SetMapper(ballMapper);
  this->Hand->SetMapper(ballMapper);
  this->SoftHand->SetMapper(ballMapper);
  this->Arrow->SetMapper(arrowMapper);
  this->Arrow->SetUserMatrix(this->ArrowFrame);
  this->Torque->SetMapper(arrowMapper);
  this->Torque->SetUserMatrix(this->TorqueFrame);
  this->Torque->GetProperty()->SetColor(0.6, 0.2, 0.8);
  vtkNew<vtkPolyDataMapper> wayMapper;
  wayMapper->SetInputData(this->Way);
  this->Trace->SetMapper(wayMapper);
  this->Trace->GetProperty()->SetLineWidth(traceWidth);
  this->Trace->GetProperty()->LightingOff();
  this->Trace->GetProperty()->SetColor(0.1, 0.65, 0.3);
  vtkNew<vtkPolyDataMapper> shapeMapper;
  shapeMapper->SetInputData(this->Shape);
  this->Field->SetMapper(shapeMapper);
  this->Field->GetProperty()->SetColor(0.95, 0.95, 0.85);
  this->Field->GetProperty()->SetLineWidth(traceWidth);
  for (vtkActor* mark : { this->Start.Get(), this->Exit.Get() })
  {
    mark->SetMapper(ballMapper);
    mark->GetProperty()->SetOpacity(markOpacity);
  }
  this->Start->GetProperty()->SetColor(0.1, 0.65, 0.3);
  this->Exit->GetProperty()->SetColor(0.9, 0.1, 0.1);
  this->Proxy->GetProperty()->SetColor(1.0, 0.75, 0.1);
  this->Hand->GetProperty()->SetColor(0.15, 0.45, 1.0);
  this->SoftHand->GetProperty()->SetColor(0.6, 0.6, 0.6);
  this->Arrow->GetProperty()->SetColor(0.9, 0.1, 0.1);
  this->MakeBox();
  for (vtkActor* actor : *this)
  {
    actor->PickableOff();
    actor->UseBoundsOff(); // else resetting the camera would fit the tool
    actor->VisibilityOff();
  }
}

/// Two corners that differ in one bit are an edge.
void vtkHapticToolProps::Internals::MakeBox() const
{
  constexpr vtkIdType corners = 8;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(corners);
  vtkNew<vtkCellArray> edges;
  for (vtkIdType corner = 0; corner < corners; ++corner)
  {
    points->SetPoint(corner, 0.0, 0.0, 0.0);
    for (vtkIdType bit = 1; bit < corners; bit *= 2)
    {
      const vtkIdType edge[2] = { corner, corner | bit };
      (corner & bit) == 0 ? edges->InsertNextCell(2, edge) : 0;
    }
  }
  this->Box->SetPoints(points);
  this->Box->SetLines(edges);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(this->Box);
  this->Workspace->SetMapper(mapper);
  this->Workspace->GetProperty()->LightingOff();
  this->Workspace->GetProperty()->SetColor(0.15, 0.45, 1.0);
}

void vtkHapticToolProps::Internals::PlaceWorkspace(vtkHapticSession* session) const
{
  double corners_W[24];
  session->GetSight()->GetWorkspaceCorners(corners_W);
  for (vtkIdType corner = 0; corner < this->Box->GetNumberOfPoints(); ++corner)
  {
    this->Box->GetPoints()->SetPoint(corner, corners_W + 3 * corner);
  }
  this->Box->GetPoints()->Modified();
}

void vtkHapticToolProps::Internals::Place(vtkActor* actor, const double p_W[3], double radius) const
{
  actor->SetPosition(p_W[0], p_W[1], p_W[2]);
  actor->SetScale(radius);
}

void vtkHapticToolProps::Internals::PlaceMarks(vtkHapticSession* session, bool shown) const
{
  const bool played = session->GetLabyrinth()->GetPlayed();
  const bool goesToStart = std::string_view(session->GetLabyrinth()->GetPhase()) == "leads";
  double start_W[3];
  double exit_W[3];
  session->GetLabyrinth()->GetPlaces(start_W, exit_W);
  this->Place(this->Start, start_W, session->GetLabyrinth()->GetReach());
  this->Place(this->Exit, exit_W, session->GetLabyrinth()->GetReach());
  this->Start->SetVisibility(played && (shown || goesToStart));
  this->Exit->SetVisibility(played && shown);
}

vtkHapticToolProps::vtkHapticToolProps() : Impl(std::make_unique<Internals>()) {}

vtkHapticToolProps::~vtkHapticToolProps()
{
  this->RemoveFromRenderer();
}

void vtkHapticToolProps::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Impl->Renderer.Get() << "\n";
  os << indent << "RelativeSize: " << this->RelativeSize << "\n";
  os << indent << "ForceScale: " << this->ForceScale << "\n";
  os << indent << "ShowTrace: " << this->ShowTrace << "\n";
  os << indent << "ShowPlaces: " << this->ShowPlaces << "\n";
}

void vtkHapticToolProps::AddToRenderer(vtkRenderer* renderer)
{
  this->RemoveFromRenderer();
  this->Impl->Renderer = renderer;
  for (vtkActor* actor : *this->Impl)
  {
    if (renderer)
    {
      renderer->AddActor(actor);
    }
  }
}

void vtkHapticToolProps::RemoveFromRenderer()
{
  for (vtkActor* actor : *this->Impl)
  {
    if (this->Impl->Renderer)
    {
      this->Impl->Renderer->RemoveActor(actor);
    }
  }
  this->Impl->Renderer = nullptr;
}

void vtkHapticToolProps::UpdateFrom(vtkHapticSession* session)
{
  Internals& impl = *this->Impl;
  // Without a scene nothing says how large a hand is, and one of a wrong size could fill the view.
  const double diagonal = session ? DiagonalOf(session) : 0.0;
  const bool shown = session && session->GetTouching() && diagonal > 0.0;
  for (vtkActor* actor : impl)
  {
    actor->SetVisibility(shown);
  }
  impl.Trace->SetVisibility(session && this->ShowTrace);
  if (session && this->ShowTrace)
  {
    session->GetLabyrinth()->GetTrace(impl.Way);
  }
  if (!shown)
  {
    return;
  }
  impl.PlaceMarks(session, this->ShowPlaces);
  impl.PlaceWorkspace(session);
  impl.Workspace->SetVisibility(session->IsOn("ShowWorkspace"));
  session->GetSight()->GetFieldShape(impl.Shape);
  const double radius = std::max(session->GetRadiusUsed(), this->RelativeSize * diagonal);
  impl.Place(impl.Proxy, session->GetProxyPosition(), radius);
  impl.Place(impl.Hand, session->GetHandPosition(), handShare * radius);
  impl.Place(impl.SoftHand, session->GetSoftHandPosition(), softHandShare * radius);
  impl.SoftHand->SetVisibility(session->IsOn("ShowSoftHand"));
  const bool held = impl.Held.UpdateFrom(session);
  impl.Proxy->SetVisibility(!held);
  impl.Hand->SetVisibility(!held);
  const double* const at_W = session->GetProxyPosition();
  const double perNewton = this->ForceScale * diagonal;
  impl.Contacts.UpdateFrom(session, perNewton);
  PlaceArrow(impl.Arrow, impl.ArrowFrame, session->GetForce(), perNewton, at_W);
  PlaceArrow(impl.Torque, impl.TorqueFrame, session->GetToolTorque(), perNewton / torqueArm_m, at_W);
}

vtkActor* vtkHapticToolProps::GetProxyActor() const
{
  return this->Impl->Proxy;
}

vtkActor* vtkHapticToolProps::GetHandActor() const
{
  return this->Impl->Hand;
}

vtkActor* vtkHapticToolProps::GetSoftHandActor() const
{
  return this->Impl->SoftHand;
}

vtkActor* vtkHapticToolProps::GetForceActor() const
{
  return this->Impl->Arrow;
}

vtkActor* vtkHapticToolProps::GetTraceActor() const
{
  return this->Impl->Trace;
}

vtkActor* vtkHapticToolProps::GetStartActor() const
{
  return this->Impl->Start;
}

vtkActor* vtkHapticToolProps::GetExitActor() const
{
  return this->Impl->Exit;
}

vtkActor* vtkHapticToolProps::GetFieldActor() const
{
  return this->Impl->Field;
}

vtkActor* vtkHapticToolProps::GetTorqueActor() const
{
  return this->Impl->Torque;
}

vtkActor* vtkHapticToolProps::GetHeldActor() const
{
  return this->Impl->Held.Solid;
}

vtkActor* vtkHapticToolProps::GetContactsActor() const
{
  return this->Impl->Contacts.Arrows;
}

vtkActor* vtkHapticToolProps::GetGhostActor() const
{
  return this->Impl->Held.Ghost;
}

vtkActor* vtkHapticToolProps::GetWorkspaceActor() const
{
  return this->Impl->Workspace;
}
