// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticToolGroup.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqHapticController.h"
#include "pqHapticLabel.h"
#include "pqHapticSourceChoice.h"
#include "pqHapticToolLine.h"
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
  : Superclass(tr("Tool"), "tool", parent), Line(new pqHapticToolLine(this))
{
  this->addSettings();
  this->connect(this->choiceOf("toolSource"), &pqHapticSourceChoice::chosen, this, &pqHapticToolGroup::hideTool);
  this->PlaceHandle = this->addButton("toolPlaceHandle", tr("Place Handle"),
    tr("Show the tool at its data, with a line whose ends are moved with the mouse: the handle and the tip"));
  this->PlaceHandle->setCheckable(true);
  this->Text = this->addText("toolText", tr("State of the tool, or the reason why there is none"));
  this->Contacts =
    this->addText("toolContacts", tr("Contacts of the tool: source, position, share of the total contact force"));
  this->connect(this->PlaceHandle, &QPushButton::toggled, this, &pqHapticToolGroup::placeHandle);
}

void pqHapticToolGroup::refresh(vtkHapticSession* session)
{
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
  return this->settings() + QList<QWidget*>{ this->PlaceHandle };
}

/// The tool is drawn at its pose instead.
void pqHapticToolGroup::hideTool() const
{
  pqPipelineSource* const tool = SourceNamed(this->choiceOf("toolSource")->source().toUtf8());
  pqView* const view = pqActiveObjects::instance().activeView();
  if (tool && view)
  {
    vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
    controller->Hide(tool->getSourceProxy(), 0, view->getViewProxy());
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
