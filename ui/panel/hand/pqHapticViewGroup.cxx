// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticViewGroup.h"

#include "pqHapticButton.h"
#include "pqHapticController.h"
#include "pqHapticFields.h"
#include "pqHapticLink.h"
#include "pqPropertyLinks.h"
#include "vtkSMProxy.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>

namespace
{
QCheckBox* Switch(QHBoxLayout* row, const char* name, const char* property, const QString& key)
{
  auto* box = new QCheckBox(pqHapticTitle(property));
  box->setObjectName(name);
  box->setToolTip(pqHapticTip(property) + " (" + key + ")");
  row->addWidget(box, 1);
  return box;
}
} // namespace

pqHapticViewGroup::pqHapticViewGroup(QWidget* parent) : Superclass(tr("Hand and view"), "view", parent)
{
  auto* buttons = new QHBoxLayout;
  this->Form->addRow(buttons);
  this->Fit = pqHapticButton(buttons, "fitSelection", tr("Fit Selection"),
    tr("Set scale and offset so that the device's workspace contains the selected sources"));
  this->Align = pqHapticButton(buttons, "align", tr("Align Now"),
    tr("Rotate the workspace about the hand: align the device's axes with right, up and towards the viewer of the "
       "view"));
  auto* switches = new QHBoxLayout;
  this->Form->addRow(switches);
  this->Precise = Switch(switches, "precision", "Precision", tr("while Ctrl+Shift+P is held"));
  this->Clutch = Switch(switches, "clutch", "Clutch", tr("while Ctrl+Shift+C is held"));
  this->addSettings();
  auto* controller = pqHapticController::instance();
  this->connect(this->Fit, &QPushButton::clicked, controller, &pqHapticController::fitSelection);
  this->connect(this->Align, &QPushButton::clicked, controller, &pqHapticController::alignWithView);
}

void pqHapticViewGroup::link(pqPropertyLinks& links, vtkSMProxy* proxy)
{
  const auto link = [&](QCheckBox* box, const char* name)
  { pqHapticLink::add(links, box, "checked", SIGNAL(toggled(bool)), proxy, name); };
  link(this->Precise, "Precision");
  link(this->Clutch, "Clutch");
  this->Superclass::link(links, proxy);
}

QList<QWidget*> pqHapticViewGroup::fields() const
{
  return QList<QWidget*>{ this->Fit, this->Align, this->Precise, this->Clutch } + this->settings();
}
