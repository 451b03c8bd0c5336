// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMenu.h"

#include "pqCoreUtilities.h"
#include "pqHapticController.h"
#include "pqHapticGuide.h"
#include "pqHapticLabyrinths.h"
#include "pqHapticPages.h"
#include "pqHapticPanel.h"
#include "pqHapticRecordings.h"

#include <QAction>
#include <QMessageBox>

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

void ShowLabyrinths()
{
  QWidget* const main = pqCoreUtilities::mainWidget();
  auto* dialog = main->findChild<pqHapticLabyrinths*>();
  dialog = dialog ? dialog : new pqHapticLabyrinths(main);
  dialog->show();
  dialog->raise();
}

void ShowGuide()
{
  QWidget* const main = pqCoreUtilities::mainWidget();
  const auto* const pages = main->findChild<pqHapticPages*>();
  if (const QString problem = pqHapticOpenGuide(pages ? pages->chosenName() : "main"); !problem.isEmpty())
  {
    QMessageBox::information(main, QObject::tr("Haptics Guide"), problem);
  }
}
} // namespace

pqHapticMenu::pqHapticMenu(QObject* parent) : Superclass(parent)
{
  auto* controller = pqHapticController::instance();
  this->setExclusive(false);
  this->addAction(controller->touchAction());
  this->addAction(controller->releaseAction());
  this->addAction(controller->markAction());
  this->addAction(controller->drawAction());
  this->addAction(controller->recordings()->recordAction());

  QAction* panel = this->addAction(tr("Show &Panel"));
  panel->setObjectName("hapticPanelAction");
  panel->setToolTip(tr("Show the panel with device, stiffness and state of the servo"));
  this->connect(panel, &QAction::triggered, this, &ShowPanel);

  QAction* labyrinths = this->addAction(tr("&Labyrinths..."));
  labyrinths->setObjectName("hapticLabyrinthsAction");
  labyrinths->setToolTip(tr("Find the path through a labyrinth by touch"));
  this->connect(labyrinths, &QAction::triggered, this, &ShowLabyrinths);

  QAction* guide = this->addAction(tr("Haptics &Guide"));
  guide->setObjectName("hapticGuideAction");
  guide->setToolTip(tr("Open the guide in the browser, at the page that describes the panel's current page"));
  this->connect(guide, &QAction::triggered, this, &ShowGuide);
}
