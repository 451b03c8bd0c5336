// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticToolBar.h"

#include "pqHapticController.h"

pqHapticToolBar::pqHapticToolBar(const QString& title, QWidget* parent) : Superclass(title, parent)
{
  this->build();
}

pqHapticToolBar::pqHapticToolBar(QWidget* parent) : Superclass(parent)
{
  this->build();
}

void pqHapticToolBar::build()
{
  this->setObjectName("hapticToolBar");
  this->setWindowTitle(tr("Haptics"));
  auto* controller = pqHapticController::instance();
  this->addAction(controller->touchAction());
  this->addAction(controller->releaseAction());
  this->addAction(controller->drawAction());
}
