// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticTouchKinds.h"

#include "pqActiveObjects.h"
#include "pqDataRepresentation.h"
#include "pqHapticController.h"
#include "pqHapticSimulatedHand.h"
#include "pqHapticStatusBar.h"
#include "pqHapticViewFollower.h"
#include "pqPipelineSource.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkHapticSession.h"
#include "vtkHapticTouchAs.h"
#include "vtkNew.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

pqHapticTouchKinds::pqHapticTouchKinds(pqHapticController* controller)
  : Superclass(controller), Controller(controller), Simulated(new pqHapticSimulatedHand(controller))
{
}

void pqHapticTouchKinds::aim(vtkHapticTouchAs& at) const
{
  const pqView* const view = pqActiveObjects::instance().activeView();
  at.SetSession(this->Controller->sessionProxy());
  at.SetView(view ? view->getProxy() : nullptr);
}

bool pqHapticTouchKinds::touchAs(pqPipelineSource* source, const QString& kind)
{
  vtkNew<vtkHapticTouchAs> at;
  this->aim(*at);
  vtkSMProxy* const proxy = source ? source->getProxy() : nullptr;
  const std::string asked = kind.isEmpty() && proxy ? at->GetLikely(proxy) : kind.toStdString();
  const QString step = asked == "not at all" ? tr("Touch %1 %2") : tr("Touch %1 as %2");
  BEGIN_UNDO_SET(step.arg(source ? source->getSMName() : QString(), QString::fromStdString(asked)));
  const bool done = at->Touch(proxy, asked.c_str());
  END_UNDO_SET();
  pqHapticSayInStatusBar(QString::fromStdString(at->GetText()));
  return done;
}

void pqHapticTouchKinds::touch(pqPipelineSource* source)
{
  if (this->touchAs(source, {}))
  {
    this->Controller->setTouching(true);
  }
}

void pqHapticTouchKinds::prepare(bool touching)
{
  const vtkHapticSession* const session = this->Controller->session();
  const pqView* const view = pqActiveObjects::instance().activeView();
  if (!touching || !session || !view || this->Controller->touching())
  {
    return;
  }
  this->takeLikely(*view);
  this->Simulated->prepare();
}

void pqHapticTouchKinds::takeLikely(const pqView& view)
{
  const vtkHapticSession* const session = this->Controller->session();
  if (this->Controller->follower()->refusal().isEmpty())
  {
    return;
  }
  vtkNew<vtkHapticTouchAs> at;
  this->aim(*at);
  for (pqRepresentation* const shown : view.getRepresentations())
  {
    const auto* const data = qobject_cast<pqDataRepresentation*>(shown);
    pqPipelineSource* const source = data && data->isVisible() ? data->getInput() : nullptr;
    const bool wanted = source && session->GetSourceTouched(source->getSMName().toUtf8().constData());
    const std::string kind = wanted ? at->GetLikely(source->getProxy()) : "";
    if (kind == "lines" || kind == "field")
    {
      this->touchAs(source, QString::fromStdString(kind));
      return;
    }
  }
}
