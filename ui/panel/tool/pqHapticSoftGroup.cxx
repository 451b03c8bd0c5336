// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSoftGroup.h"

#include "pqHapticLabel.h"
#include "vtkHapticSession.h"

pqHapticSoftGroup::pqHapticSoftGroup(QWidget* parent) : Superclass(tr("Soft body"), "soft", "SoftSource", parent)
{
  this->addButtons({ "softUse", tr("Press Selected Source"),
                     tr("Make the active source of the pipeline browser, made by the filter Soft Body, deform under "
                        "the hand and in the view") },
    { "softLeave", tr("No Soft Body"), tr("Make the soft body rigid again, in its visible shape") });
  this->Text = this->addText("softText", tr("Soft body: material, solver rate, age of the solution, strain"));
  this->addSettings();
}

void pqHapticSoftGroup::refresh(vtkHapticSession* session)
{
  this->refreshButtons(session, session ? session->GetSettingText("SoftSource") : "");
  pqHapticSay(this->Text, session ? QString::fromUtf8(session->GetSoftText()) : QString());
}

QList<QWidget*> pqHapticSoftGroup::fields() const
{
  return this->Superclass::fields() + this->settings();
}
