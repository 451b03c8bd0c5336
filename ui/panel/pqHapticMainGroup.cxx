// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMainGroup.h"

#include "pqHapticArrayChoice.h"
#include "pqHapticFields.h"
#include "pqHapticLabel.h"
#include "pqHapticLink.h"
#include "pqHapticRecordingRows.h"
#include "pqPropertyLinks.h"
#include "vtkHapticSession.h"
#include "vtkSMProxy.h"

#include <QFormLayout>

namespace
{
constexpr int mainSpacing = 2; // all rows fit on a screen of 768 lines [pixels]
} // namespace

pqHapticMainGroup::pqHapticMainGroup(QWidget* parent) : Superclass(parent)
{
  this->setObjectName("mainGroup");
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(mainSpacing);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  this->Rows.add(form, "main");
  this->Stiffness = new pqHapticArrayChoice(this);
  this->Stiffness->setObjectName("mainStiffnessArray");
  this->Stiffness->setToolTip(pqHapticTip("StiffnessArray"));
  form->addRow(pqHapticTitle("StiffnessArray"), this->Stiffness);
  this->Recording = new pqHapticRecordingRows(this);
  form->addRow(this->Recording);
  auto* warning = pqHapticLabel(this, "notClinical", tr("No part of it has been validated for any medical purpose"));
  warning->setText(tr("Not for clinical use."));
  form->addRow(warning);
}

pqHapticMainGroup::~pqHapticMainGroup() = default;

void pqHapticMainGroup::setProxy(vtkSMProxy* proxy, pqPropertyLinks& links)
{
  if (proxy)
  {
    this->Recording->link(proxy, links);
    this->Rows.link(links, proxy);
    pqHapticLink::add(links, this->Stiffness, "array", SIGNAL(arrayChanged()), proxy, "StiffnessArray");
  }
}

void pqHapticMainGroup::refresh(vtkHapticSession* session)
{
  this->findChild<QWidget*>("pressDepth")->setEnabled(session && session->GetFollowsMouse());
  this->Recording->refresh(session);
}

void pqHapticMainGroup::setArrayNames(const QStringList& names)
{
  this->Stiffness->setNames(names);
}

QList<QWidget*> pqHapticMainGroup::fields() const
{
  return this->Rows.fields("main") + QList<QWidget*>{ this->Stiffness } + this->Recording->fields();
}
