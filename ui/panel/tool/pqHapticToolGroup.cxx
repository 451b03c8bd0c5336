// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticToolGroup.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqHapticController.h"
#include "pqHapticLabel.h"
#include "pqHapticToolLine.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqView.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include <QPushButton>

namespace
{
pqPipelineSource* SourceNamed(const char* name)
{
  return pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(QString::fromUtf8(name));
}
} // namespace

pqHapticToolGroup::pqHapticToolGroup(QWidget* parent)
  : Superclass(tr("Tool"), "tool", "ToolSource", parent), Line(new pqHapticToolLine(this))
{
  this->addButtons({ "toolUse", tr("Use Selected Source"),
                     tr("Hold the surface of the active source of the pipeline browser as tool. The source is hidden; "
                        "the tool is drawn at its pose, with a ghost at the pose of the hand") },
    { "toolBall", tr("Take the Ball"), tr("Touch with the proxy sphere again") });
  this->PlaceHandle = this->addButton("toolPlaceHandle", tr("Place Handle"), // three in a row would widen the panel
    tr("Show the tool at its data, with a line whose ends are moved with the mouse: the handle and the tip"));
  this->PlaceHandle->setCheckable(true);
  this->Text = this->addText("toolText", tr("State of the tool, or the reason why there is none"));
  this->Contacts =
    this->addText("toolContacts", tr("Contacts of the tool: source, position, share of the total contact force"));
  this->addSettings();
  this->connect(this->PlaceHandle, &QPushButton::toggled, this, &pqHapticToolGroup::placeHandle);
}

void pqHapticToolGroup::refresh(vtkHapticSession* session)
{
  this->refreshButtons(session, session ? session->GetSettingText("ToolSource") : "");
  pqPipelineSource* const tool = session ? SourceNamed(session->GetSettingText("ToolSource")) : nullptr;
  this->PlaceHandle->setEnabled(tool);
  if (!tool || tool != this->Placed)
  {
    this->PlaceHandle->setChecked(false);
  }
  pqHapticSay(this->Text, session ? QString::fromUtf8(session->GetToolText()) : QString());
  pqHapticSay(this->Contacts, session ? QString::fromUtf8(session->GetToolContacts()).trimmed() : QString());
}

QList<QWidget*> pqHapticToolGroup::fields() const
{
  return this->Superclass::fields() + QList<QWidget*>{ this->PlaceHandle } + this->settings();
}

void pqHapticToolGroup::use(pqOutputPort& port)
{
  this->Superclass::use(port);
  if (pqView* const view = pqActiveObjects::instance().activeView())
  {
    vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
    controller->Hide(port.getSourceProxy(), port.getPortNumber(), view->getViewProxy());
    view->render();
  }
}

void pqHapticToolGroup::placeHandle(bool shown)
{
  if (!shown)
  {
    this->Line->hide();
    return;
  }
  vtkSMProxy* const proxy = pqHapticController::instance()->sessionProxy();
  this->Placed = proxy ? SourceNamed(vtkSMPropertyHelper(proxy, "ToolSource").GetAsString()) : nullptr;
  if (this->Placed)
  {
    this->Line->show(proxy, this->Placed);
  }
}
