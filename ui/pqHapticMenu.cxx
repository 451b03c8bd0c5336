// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMenu.h"

#include "pqCoreUtilities.h"
#include "pqHapticController.h"
#include "pqHapticPanel.h"

#include <QAction>

namespace
{
void ShowPanel()
{
  if (auto* panel = pqCoreUtilities::mainWidget()->findChild<pqHapticPanel*>())
  {
    panel->show();
    panel->raise();
    panel->setFocus();
  }
}
} // namespace

pqHapticMenu::pqHapticMenu(QObject* parent) : Superclass(parent)
{
  auto* controller = pqHapticController::instance();
  this->setExclusive(false);
  this->addAction(controller->touchAction());
  this->addAction(controller->releaseAction());

  QAction* panel = this->addAction(tr("Show &Panel"));
  panel->setObjectName("hapticPanelAction");
  panel->setToolTip(tr("Show the panel with device, stiffness and the servo's state"));
  this->connect(panel, &QAction::triggered, this, &ShowPanel);
}
