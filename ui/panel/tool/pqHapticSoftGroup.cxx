// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSoftGroup.h"

#include "pqHapticLabel.h"
#include "vtkHapticSession.h"

pqHapticSoftGroup::pqHapticSoftGroup(QWidget* parent) : Superclass(tr("Soft body"), "soft", "SoftSource", parent)
{
  this->addButtons({ "softUse", tr("Press Selected Source"),
                     tr("The source that is active in the pipeline browser, made by the filter Soft Body, gives way "
                        "under the hand and bends in the view") },
    { "softLeave", tr("Nothing Gives Way"), tr("What gave way is rigid again, as it is shown") });
  this->Text = this->addText("softText",
    tr("What gives way: its material, how often it is computed, how old what is felt of it is, how strained it is"));
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
