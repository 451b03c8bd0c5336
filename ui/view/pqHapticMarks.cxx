// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMarks.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkHapticInspection.h"
#include "vtkHapticMarkProps.h"
#include "vtkHapticSession.h"
#include "vtkPVRenderView.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSourceProxy.h"

#include <cstring>

namespace
{
constexpr const char* marksSource = "HapticMarks";

bool IsMarksSource(const pqPipelineSource* source)
{
  return source && std::strcmp(source->getProxy()->GetXMLName(), marksSource) == 0;
}
} // namespace

pqHapticMarks::pqHapticMarks(QObject* parent) : Superclass(parent)
{
  auto* const model = pqApplicationCore::instance()->getServerManagerModel();
  this->connect(model, &pqServerManagerModel::sourceAdded, this, &pqHapticMarks::fill);
}

pqHapticMarks::~pqHapticMarks()
{
  this->setProxy(nullptr);
}

vtkHapticSession* pqHapticMarks::session() const
{
  return this->Proxy ? vtkHapticSession::SafeDownCast(this->Proxy->GetClientSideObject()) : nullptr;
}

void pqHapticMarks::setProxy(vtkSMProxy* proxy)
{
  if (this->Proxy)
  {
    this->Proxy->RemoveObserver(this->Observer);
  }
  this->Proxy = proxy;
  this->Observer = proxy ? proxy->AddObserver(vtkCommand::UpdateEvent, this, &pqHapticMarks::proxyUpdated) : 0;
  this->follow();
}

void pqHapticMarks::proxyUpdated()
{
  if (this->session() && this->Drawn != this->session()->GetSettingText("MarksText"))
  {
    this->follow();
  }
}

void pqHapticMarks::leaveView()
{
  for (const QMetaObject::Connection& connection : this->Connections)
  {
    this->disconnect(connection);
  }
  this->Connections.clear();
  this->Props->SetRenderer(nullptr);
  this->View = nullptr;
}

void pqHapticMarks::setView(pqRenderView* view)
{
  if (!view || view == this->View)
  {
    return; // a table is active, and the view beside it shows the marks as before
  }
  const QPointer<pqRenderView> before = this->View;
  this->leaveView();
  if (before && this->Props->GetNumberOfMarks() > 0)
  {
    before->render();
  }
  this->View = view;
  const auto follow = [this] { this->follow(); };
  this->Connections = { this->connect(view, &pqView::representationAdded, this, follow),
    this->connect(view, &pqView::representationRemoved, this, follow),
    this->connect(view, &pqView::representationVisibilityChanged, this, follow) };
  this->follow();
}

bool pqHapticMarks::isShownBySource() const
{
  for (pqRepresentation* const shown : this->View->getRepresentations())
  {
    const auto* const data = qobject_cast<pqDataRepresentation*>(shown);
    if (data && data->isVisible() && IsMarksSource(data->getInput()))
    {
      const vtkSMPropertyHelper text(data->getInput()->getProxy(), "Text");
      return std::strcmp(text.GetAsString(), this->session()->GetSettingText("MarksText")) == 0;
    }
  }
  return false;
}

void pqHapticMarks::follow()
{
  // Without a session a view may be ending, and says so while it has no proxy any more.
  auto* const drawn = this->View && this->session()
                        ? vtkPVRenderView::SafeDownCast(this->View->getRenderViewProxy()->GetClientSideObject())
                        : nullptr;
  vtkHapticSession* const marked = drawn && !this->isShownBySource() ? this->session() : nullptr;
  this->Drawn = this->session() ? this->session()->GetSettingText("MarksText") : "";
  const int before = this->Props->GetNumberOfMarks();
  this->Props->SetRenderer(drawn ? drawn->GetRenderer(vtkPVRenderView::NON_COMPOSITED_RENDERER) : nullptr);
  this->Props->UpdateFrom(marked);
  if (drawn && (before > 0 || this->Props->GetNumberOfMarks() > 0))
  {
    this->View->render();
  }
}

void pqHapticMarks::goTo(int mark) const
{
  if (!this->View || !this->session() || mark < 0 || mark >= this->session()->GetNumberOfMarks())
  {
    return;
  }
  double at[3];
  this->session()->GetInspection()->GetMarkPosition(mark, at);
  vtkCamera* const camera = this->View->getRenderViewProxy()->GetActiveCamera();
  const double* const focus = camera->GetFocalPoint();
  const double* const eye = camera->GetPosition();
  const double moved[3] = { eye[0] + at[0] - focus[0], eye[1] + at[1] - focus[1], eye[2] + at[2] - focus[2] };
  camera->SetPosition(moved);
  camera->SetFocalPoint(at);
  this->View->getRenderViewProxy()->SynchronizeCameraProperties();
  this->View->setCenterOfRotation(at);
  this->View->render();
}

void pqHapticMarks::fill(pqPipelineSource* source) const
{
  if (!this->session() || !IsMarksSource(source) ||
      *vtkSMPropertyHelper(source->getProxy(), "Text").GetAsString() != '\0')
  {
    return;
  }
  const std::string saved = this->session()->GetInspection()->GetSavedMarks();
  vtkSMPropertyHelper(source->getProxy(), "Text")
    .Set(saved.empty() ? this->session()->GetSettingText("MarksText") : saved.c_str());
}
