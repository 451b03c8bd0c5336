// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSoftGroup.h"

#include "pqActiveObjects.h"
#include "pqHapticButton.h"
#include "pqHapticLabel.h"
#include "pqHapticNamedSource.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "vtkHapticSession.h"

#include <QFormLayout>
#include <QHBoxLayout>

namespace
{
void PressSelected()
{
  if (pqOutputPort* const port = pqActiveObjects::instance().activePort())
  {
    pqHapticNameSource("SoftSource", port->getSource()->getSMName());
  }
}
} // namespace

pqHapticSoftGroup::pqHapticSoftGroup(QWidget* parent) : Superclass(tr("Soft body"), parent)
{
  this->setObjectName("softGroup");
  auto* form = new QFormLayout(this);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  auto* buttons = new QHBoxLayout;
  form->addRow(buttons);
  this->Use = pqHapticButton(buttons, "softUse", tr("Press Selected Source"),
    tr("The source that is active in the pipeline browser, made by the filter Soft Body, gives way under the hand and "
       "bends in the view"));
  this->Leave =
    pqHapticButton(buttons, "softLeave", tr("Nothing Gives Way"), tr("What gave way is rigid again, as it is shown"));
  this->Text = pqHapticLabel(this, "softText",
    tr("What gives way: its material, how often it is computed, how old what is felt of it is, how strained it is"));
  form->addRow(this->Text);
  this->Rows.add(form, "soft");
  this->connect(this->Use, &QPushButton::clicked, this, &PressSelected);
  this->connect(this->Leave, &QPushButton::clicked, this, [] { pqHapticNameSource("SoftSource", {}); });
}

pqHapticSoftGroup::~pqHapticSoftGroup() = default;

void pqHapticSoftGroup::link(pqPropertyLinks& links, vtkSMProxy* proxy)
{
  this->Rows.link(links, proxy);
}

void pqHapticSoftGroup::refresh(vtkHapticSession* session)
{
  this->Use->setEnabled(session && pqActiveObjects::instance().activePort());
  this->Leave->setEnabled(session && *session->GetSettingText("SoftSource") != '\0');
  pqHapticSay(this->Text, session ? QString::fromUtf8(session->GetSoftText()) : QString());
}

QList<QWidget*> pqHapticSoftGroup::fields() const
{
  return QList<QWidget*>{ this->Use, this->Leave } + this->Rows.fields("soft");
}
