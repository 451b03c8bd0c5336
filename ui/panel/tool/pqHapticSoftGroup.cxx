// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSoftGroup.h"

#include "pqHapticLabel.h"
#include "vtkHapticSession.h"

pqHapticSoftGroup::pqHapticSoftGroup(QWidget* parent) : Superclass(tr("Soft body"), "soft", parent)
{
  this->addSettings();
  this->Text = this->addText("softText", tr("Soft body: material, solver rate, age of the solution, strain"));
}

void pqHapticSoftGroup::refresh(vtkHapticSession* session)
{
  pqHapticSay(this->Text, session ? QString::fromUtf8(session->GetSoftText()) : QString());
}

QList<QWidget*> pqHapticSoftGroup::fields() const
{
  return this->settings();
}
