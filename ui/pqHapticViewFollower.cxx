// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticViewFollower.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "vtkHapticSession.h"
#include "vtkHapticViewScene.h"
#include "vtkSMRenderViewProxy.h"

pqHapticViewFollower::pqHapticViewFollower(QObject* parent) : Superclass(parent)
{
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  this->connect(model, &pqServerManagerModel::preViewRemoved, this, &pqHapticViewFollower::viewRemoved);
  this->connect(&pqActiveObjects::instance(), &pqActiveObjects::viewChanged, this, &pqHapticViewFollower::setView);
  this->setView(pqActiveObjects::instance().activeView());
}

pqHapticViewFollower::~pqHapticViewFollower() = default;

void pqHapticViewFollower::setSession(vtkHapticSession* session)
{
  this->Scene->SetSession(session);
  this->refresh();
}

void pqHapticViewFollower::setActive(bool active)
{
  this->Active = active;
  this->refresh();
}

QString pqHapticViewFollower::report() const
{
  return QString::fromUtf8(this->Scene->GetReport());
}

QStringList pqHapticViewFollower::arrayNames() const
{
  return QString::fromStdString(this->Scene->GetArrayNames()).split('\n', Qt::SkipEmptyParts);
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
  follow(&pqView::updateDataEvent);
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
  if (this->Active && this->Scene->Update())
  {
    Q_EMIT this->sceneChanged();
  }
}
