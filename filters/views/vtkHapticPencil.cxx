// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPencil.h"

#include "vtkCommand.h"
#include "vtkHapticPencilStroke.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkWeakPointer.h"

#include <vector>

vtkStandardNewMacro(vtkHapticPencil);

namespace
{
/// Before styles (0), widgets (0.5) and the mouse that leads a hand (1).
constexpr float beforeOthers = 2.0F;

void PutPoints(vtkSMProxy* line, const std::vector<palpate::Vec3>& points_W)
{
  vtkSMPropertyHelper(line, "Points").Set(points_W.front().data(), 3 * static_cast<unsigned int>(points_W.size()));
  line->UpdateVTKObjects();
}

vtkSMProxySelectionModel* ActiveSources(vtkSMProxy* proxy)
{
  return proxy->GetSessionProxyManager()->GetSelectionModel("ActiveSources");
}

void MakeActive(vtkSMProxy* source, vtkSMProxySelectionModel* sources)
{
  if (sources)
  {
    sources->SetCurrentProxy(source, vtkSMProxySelectionModel::CLEAR_AND_SELECT);
  }
}

/// Shown in the view, while the active source stays so: a panel need not follow each point.
vtkSmartPointer<vtkSMSourceProxy> NewLine(vtkSMViewProxy* view, const std::vector<palpate::Vec3>& points_W)
{
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  auto line = vtkSmartPointer<vtkSMSourceProxy>::Take(
    vtkSMSourceProxy::SafeDownCast(view->GetSessionProxyManager()->NewProxy("sources", "PolyLineSource")));
  vtkSMProxySelectionModel* const sources = ActiveSources(view);
  const vtkSmartPointer<vtkSMProxy> active = sources ? sources->GetCurrentProxy() : nullptr;
  controller->InitializeProxy(line);
  PutPoints(line, points_W);
  controller->RegisterPipelineProxy(line);
  MakeActive(active, sources);
  line->UpdatePipeline();
  controller->Show(line, 0, view);
  return line;
}
} // namespace

class vtkHapticPencil::Internals
{
public:
  vtkHapticPencil* Owner = nullptr;
  vtkWeakPointer<vtkSMRenderViewProxy> View;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkSmartPointer<vtkHapticSession> Session;
  std::vector<unsigned long> Observers;
  unsigned long ViewObserver = 0; ///< of the view's deletion
  bool Active = false;
  bool Drawing = false; ///< the button is held
  vtkHapticPencilStroke Stroke;
  vtkHapticSurfaceGround Surfaces;       ///< that are drawn on
  vtkWeakPointer<vtkSMSourceProxy> Line; ///< the pipeline keeps it

  /// True: no other observer is to hear of it.
  bool Heard(vtkObject*, unsigned long event, void*);
  void Watch(vtkSMRenderViewProxy* view);
  void ViewDeleted();
  vtkHapticPencilStroke NewStroke();
  void Draw();
  void ShowStroke();
  void End();
  void Listen();
  void Forget();
};

bool vtkHapticPencil::Internals::Heard(vtkObject*, unsigned long event, void*)
{
  if (!this->View)
  {
    return false;
  }
  if (event == vtkCommand::LeftButtonPressEvent && !this->Interactor->GetShiftKey())
  {
    this->End();
    this->Drawing = true;
    this->Stroke = this->NewStroke();
    this->Draw();
    return true;
  }
  const bool taken = this->Drawing && event == vtkCommand::LeftButtonReleaseEvent;
  if (this->Drawing)
  {
    this->Draw();
  }
  if (taken)
  {
    this->End();
  }
  return taken;
}

vtkHapticPencilStroke vtkHapticPencil::Internals::NewStroke()
{
  palpate::Vec3 point_W, normal_W;
  if (this->Session && this->Session->GetPlane(point_W.data(), normal_W.data()))
  {
    return vtkHapticPencilStroke(vtkHapticPlaneGround(this->View->GetRenderer(), point_W, normal_W));
  }
  const int* at = this->Interactor->GetEventPosition();
  const vtkHapticPencilGround surface = this->Surfaces.At(this->View, at[0], at[1]);
  return vtkHapticPencilStroke(surface ? surface : vtkHapticScreenGround(this->View->GetRenderer()));
}

void vtkHapticPencil::Internals::Draw()
{
  const int* at = this->Interactor->GetEventPosition();
  const bool added = this->Stroke.Add(this->View->GetRenderer(), at[0], at[1]);
  const std::size_t points = this->Stroke.GetPoints().size();
  if (!added || points < 2)
  {
    return;
  }
  if (points == 2)
  {
    this->Owner->InvokeEvent(vtkCommand::StartInteractionEvent);
    this->Line = NewLine(this->View, this->Stroke.GetPoints());
  }
  this->ShowStroke();
}

void vtkHapticPencil::Internals::ShowStroke()
{
  if (this->Line)
  {
    PutPoints(this->Line, this->Stroke.GetPoints());
    this->Owner->InvokeEvent(vtkCommand::InteractionEvent);
  }
}

void vtkHapticPencil::Internals::End()
{
  const bool begun = this->Stroke.GetPoints().size() >= 2;
  if (begun && this->Line)
  {
    this->Stroke.Simplify();
    PutPoints(this->Line, this->Stroke.GetPoints());
  }
  this->Drawing = false;
  this->Stroke = {};
  const vtkSmartPointer<vtkSMProxy> line = this->Line.Get();
  this->Line = nullptr;
  if (begun)
  {
    this->Owner->InvokeEvent(vtkCommand::EndInteractionEvent);
  }
  if (line)
  {
    MakeActive(line, ActiveSources(line));
  }
}

void vtkHapticPencil::Internals::Listen()
{
  this->Interactor = this->View && this->Active ? this->View->GetInteractor() : nullptr;
  if (!this->Interactor)
  {
    return;
  }
  for (unsigned long event :
    { vtkCommand::LeftButtonPressEvent, vtkCommand::MouseMoveEvent, vtkCommand::LeftButtonReleaseEvent })
  {
    this->Observers.push_back(this->Interactor->AddObserver(event, this, &Internals::Heard, beforeOthers));
  }
}

void vtkHapticPencil::Internals::Forget()
{
  for (unsigned long observer : this->Observers)
  {
    if (this->Interactor)
    {
      this->Interactor->RemoveObserver(observer);
    }
  }
  this->Observers.clear();
}

void vtkHapticPencil::Internals::Watch(vtkSMRenderViewProxy* view)
{
  if (this->View)
  {
    this->View->RemoveObserver(this->ViewObserver);
  }
  this->View = view;
  this->ViewObserver = view ? view->AddObserver(vtkCommand::DeleteEvent, this, &Internals::ViewDeleted) : 0;
}

void vtkHapticPencil::Internals::ViewDeleted()
{
  this->Forget();
  this->View = nullptr;
  this->End();
  this->Owner->Modified();
}

vtkHapticPencil::vtkHapticPencil() : Impl(std::make_unique<Internals>())
{
  this->Impl->Owner = this;
}

vtkHapticPencil::~vtkHapticPencil()
{
  this->Impl->Forget();
  this->Impl->Watch(nullptr);
}

void vtkHapticPencil::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->GetView() << "\n";
  os << indent << "Active: " << this->GetActive() << "\n";
  os << indent << "Line: " << this->GetLine() << "\n";
}

void vtkHapticPencil::SetView(vtkSMProxy* view)
{
  auto* next = vtkSMRenderViewProxy::SafeDownCast(view);
  if (next != this->Impl->View)
  {
    this->Impl->End();
    this->Impl->Forget();
    this->Impl->Surfaces = {};
    this->Impl->Watch(next);
    this->Impl->Listen();
    this->Modified();
  }
}

vtkSMProxy* vtkHapticPencil::GetView() const
{
  return this->Impl->View;
}

void vtkHapticPencil::SetSession(vtkHapticSession* session)
{
  this->Impl->Session = session;
}

void vtkHapticPencil::SetActive(bool active)
{
  if (active != this->Impl->Active)
  {
    this->Impl->End();
    this->Impl->Forget();
    this->Impl->Surfaces = {};
    this->Impl->Active = active;
    this->Impl->Listen();
    this->Modified();
  }
}

bool vtkHapticPencil::GetActive() const
{
  return this->Impl->Active;
}

vtkSMProxy* vtkHapticPencil::GetLine() const
{
  return this->Impl->Line;
}
