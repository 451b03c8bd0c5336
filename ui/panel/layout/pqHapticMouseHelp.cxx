// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMouseHelp.h"

#include "pqHapticController.h"
#include "pqHapticFold.h"
#include "pqHapticLabel.h"
#include "pqHapticMouse.h"
#include "vtkHapticSession.h"

#include <QVBoxLayout>

pqHapticMouseHelp::pqHapticMouseHelp(QWidget* parent) : Superclass(parent)
{
  this->setObjectName("help");
  const QString tip = tr("Functions of mouse and keyboard in the view while they move the hand");
  this->Fold = new pqHapticFold(this, tr("?"), tip);
  this->Text = pqHapticLabel(this, "mouseHelp", tip);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(this->Text);
  this->Fold->setChecked(true);
}

pqHapticMouseHelp::~pqHapticMouseHelp() = default;

void pqHapticMouseHelp::refresh(vtkHapticSession* session)
{
  const QString text = pqHapticController::instance()->mouse()->help();
  this->Text->setText(text);
  this->Text->setVisible(!text.isEmpty());
  this->Fold->setEnabled(!text.isEmpty());
  const bool presses = session && session->GetFollowsMouse() && session->GetForceMagnitude() > 0.0;
  if (presses && !this->Learnt)
  {
    this->Learnt = true;
    this->Fold->setChecked(false);
  }
}
