// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticViewFollower.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqInteractivePropertyWidgetAbstract.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "vtkCommand.h"
#include "vtkHapticLengthUnit.h"
#include "vtkHapticSession.h"
#include "vtkHapticShownArrays.h"
#include "vtkHapticViewScene.h"
#include "vtkPVRenderView.h"
#include "vtkSMRenderViewProxy.h"

#include <algorithm>

namespace
{
/// Where a source is edited; null: nowhere.
pqProxyWidget* FindPanel(const vtkSMProxy* source)
{
  const QWidget* window = pqCoreUtilities::mainWidget();
  const auto panels = window ? window->findChildren<pqProxyWidget*>() : QList<pqProxyWidget*>();
  const auto found =
    std::find_if(panels.begin(), panels.end(), [&](const auto* panel) { return panel->proxy() == source; });
  return found == panels.end() ? nullptr : *found;
}

bool ShowsWidget(const pqProxyWidget& panel)
{
  const auto widgets = panel.findChildren<pqInteractivePropertyWidgetAbstract*>();
  return std::any_of(widgets.begin(), widgets.end(), [](const auto* widget) { return widget->isWidgetVisible(); });
}
} // namespace

pqHapticViewFollower::pqHapticViewFollower(QObject* parent) : Superclass(parent)
{
  this->Scene->SetReadsAhead(true);
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  this->connect(model, &pqServerManagerModel::preViewRemoved, this, &pqHapticViewFollower::viewRemoved);
  this->connect(&pqActiveObjects::instance(), &pqActiveObjects::viewChanged, this, &pqHapticViewFollower::setView);
  this->connect(&pqActiveObjects::instance(), &pqActiveObjects::sourceChanged, this, &pqHapticViewFollower::refresh);
  this->setView(pqActiveObjects::instance().activeView());
}

pqHapticViewFollower::~pqHapticViewFollower()
{
  this->setSession(nullptr);
}

void pqHapticViewFollower::setSession(vtkHapticSession* session)
{
  if (vtkHapticSession* const before = this->Scene->GetSession())
  {
    before->RemoveObserver(this->Observer);
  }
  this->Scene->SetSession(session);
  this->Observer =
    session ? session->AddObserver(vtkCommand::UpdateDataEvent, this, &pqHapticViewFollower::handOver) : 0;
  this->refresh();
}

void pqHapticViewFollower::setActive(bool active)
{
  if (active && !this->Active)
  {
    this->Scene->TakeAgain();
  }
  if (this->Active && !active)
  {
    this->Scene->ShowHanded(); // it is not asked for any more
  }
  this->Active = active;
  this->refresh();
}

QString pqHapticViewFollower::report() const
{
  return QString::fromUtf8(this->Scene->GetReport());
}

QString pqHapticViewFollower::refusal() const
{
  return QString::fromStdString(this->Scene->GetRefusal());
}

QString pqHapticViewFollower::takeColorRange(vtkSMProxy* session) const
{
  return QString::fromStdString(this->Scene->TakeColorRange(session));
}

QString pqHapticViewFollower::lengthUnit(QString& reason) const
{
  const vtkHapticLengthUnit found = vtkHapticLengthUnitOf(this->View ? this->View->getProxy() : nullptr);
  reason = QString::fromStdString(found.Reason);
  return QString::fromStdString(found.Unit);
}

QStringList pqHapticViewFollower::arrayNames() const
{
  return QString::fromStdString(this->Scene->GetArrayNames()).split('\n', Qt::SkipEmptyParts);
}

QStringList pqHapticViewFollower::shownArrays() const
{
  QStringList names;
  for (const std::string& name : vtkHapticShownArrays(this->View ? this->View->getProxy() : nullptr))
  {
    names << QString::fromStdString(name);
  }
  return names;
}

QStringList pqHapticViewFollower::fieldNames(int components) const
{
  return QString::fromStdString(this->Scene->GetFieldNames(components)).split('\n', Qt::SkipEmptyParts);
}

void pqHapticViewFollower::setView(pqView* view)
{
  auto* next = qobject_cast<pqRenderView*>(view);
  if (next != this->View || !next)
  {
    this->View = next;
    this->Touched = next ? next : this->Touched;
    this->connectView();
    this->Scene->SetView(view ? view->getProxy() : nullptr);
    Q_EMIT this->viewChanged(next);
  }
  this->refresh();
}

void pqHapticViewFollower::connectView()
{
  for (const QMetaObject::Connection& connection : this->Connections)
  {
    this->disconnect(connection);
  }
  this->Connections.clear();
  if (!this->View)
  {
    return;
  }
  const auto follow = [this](auto signal)
  { this->Connections.push_back(this->connect(this->View.data(), signal, this, &pqHapticViewFollower::refresh)); };
  follow(&pqView::endRender);
  follow(&pqView::representationAdded);
  follow(&pqView::representationRemoved);
  follow(&pqView::representationVisibilityChanged);
}

void pqHapticViewFollower::viewRemoved(pqView* view)
{
  if (view == this->Touched)
  {
    this->Touched = nullptr;
    Q_EMIT this->viewClosing();
    this->setView(nullptr);
  }
}

void pqHapticViewFollower::refresh()
{
  if (this->Active)
  {
    this->handOver();
  }
}

/// While a camera turns ParaView may draw coarser data, which are not to be touched.
bool pqHapticViewFollower::drewCoarser() const
{
  auto* const drawn =
    this->View ? vtkPVRenderView::SafeDownCast(this->View->getRenderViewProxy()->GetClientSideObject()) : nullptr;
  return drawn && drawn->GetUsedLODForLastRender();
}

void pqHapticViewFollower::handOver()
{
  if (this->drewCoarser())
  {
    return;
  }
  this->Scene->SetDrawing(this->newDrawing());
  this->Scene->Update();
}

vtkSMProxy* pqHapticViewFollower::newDrawing()
{
  const pqPipelineSource* source = pqActiveObjects::instance().activeSource();
  if (!source || source->modifiedState() != pqProxy::UNINITIALIZED)
  {
    return nullptr;
  }
  if (!this->Panel || this->Panel->proxy() != source->getProxy())
  {
    this->Panel = FindPanel(source->getProxy());
  }
  return this->Panel && ShowsWidget(*this->Panel) ? source->getProxy() : nullptr;
}
