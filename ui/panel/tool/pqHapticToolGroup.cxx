// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticToolGroup.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqHapticButton.h"
#include "pqHapticController.h"
#include "pqHapticLabel.h"
#include "pqHapticNamedSource.h"
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

#include <QFormLayout>
#include <QHBoxLayout>

namespace
{
pqPipelineSource* SourceNamed(const char* name)
{
  return pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(QString::fromUtf8(name));
}
} // namespace

pqHapticToolGroup::pqHapticToolGroup(QWidget* parent) : Superclass(tr("Tool"), parent), Line(new pqHapticToolLine(this))
{
  this->setObjectName("toolGroup");
  auto* form = new QFormLayout(this);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  auto* buttons = new QHBoxLayout;
  form->addRow(buttons);
  this->Use = pqHapticButton(buttons, "toolUse", tr("Use Selected Source"),
    tr("The hand holds the surface of the source that is active in the pipeline browser, which is hidden: the tool is "
       "drawn where it is, and a ghost where the hand would have it"));
  this->Ball = pqHapticButton(buttons, "toolBall", tr("Take the Ball"), tr("The hand touches with its ball again"));
  this->PlaceHandle = pqHapticButton(this, "toolPlaceHandle", tr("Place Handle"),
    tr("Shows the tool where its data are, and a line in it whose ends are drawn with the mouse: where the hand holds "
       "the "
       "tool, and its tip"));
  this->PlaceHandle->setCheckable(true);
  form->addRow(this->PlaceHandle); // three in a row would make the panel wider
  this->Text = pqHapticLabel(this, "toolText", tr("Which tool is held and how it is, or why none is"));
  form->addRow(this->Text);
  this->Contacts = pqHapticLabel(this, "toolContacts", tr("What pushes the tool: source, place, share of all pushes"));
  form->addRow(this->Contacts);
  this->Rows.add(form, "tool");
  this->connect(this->Use, &QPushButton::clicked, this, &pqHapticToolGroup::useSelected);
  this->connect(this->Ball, &QPushButton::clicked, this, &pqHapticToolGroup::takeBall);
  this->connect(this->PlaceHandle, &QPushButton::toggled, this, &pqHapticToolGroup::placeHandle);
}

pqHapticToolGroup::~pqHapticToolGroup() = default;

void pqHapticToolGroup::link(pqPropertyLinks& links, vtkSMProxy* proxy)
{
  this->Rows.link(links, proxy);
}

void pqHapticToolGroup::refresh(vtkHapticSession* session)
{
  this->Use->setEnabled(session && pqActiveObjects::instance().activePort());
  this->Ball->setEnabled(session && *session->GetSettingText("ToolSource") != '\0');
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
  return QList<QWidget*>{ this->Use, this->Ball, this->PlaceHandle } + this->Rows.fields("tool");
}

void pqHapticToolGroup::useSelected()
{
  pqOutputPort* const port = pqActiveObjects::instance().activePort();
  if (!port)
  {
    return;
  }
  pqHapticNameSource("ToolSource", port->getSource()->getSMName());
  if (pqView* const view = pqActiveObjects::instance().activeView())
  {
    vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
    controller->Hide(port->getSourceProxy(), port->getPortNumber(), view->getViewProxy());
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

void pqHapticToolGroup::takeBall()
{
  pqHapticNameSource("ToolSource", {});
}
