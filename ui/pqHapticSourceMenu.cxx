// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSourceMenu.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqHapticController.h"
#include "pqHapticTouchKinds.h"
#include "pqPipelineBrowserWidget.h"
#include "pqServerManagerModel.h"

#include <QAction>
#include <QMenu>
#include <QTimer>

pqHapticSourceMenu::pqHapticSourceMenu(pqHapticController* controller) : Superclass(controller), Controller(controller)
{
  auto* const model = pqApplicationCore::instance()->getServerManagerModel();
  this->connect(model, &pqServerManagerModel::serverAdded, this, &pqHapticSourceMenu::install);
  QTimer::singleShot(0, this, &pqHapticSourceMenu::install);
}

void pqHapticSourceMenu::install()
{
  const QWidget* const window = pqCoreUtilities::mainWidget();
  const auto* const browser = window ? window->findChild<pqPipelineBrowserWidget*>() : nullptr;
  if (browser && !this->Installed)
  {
    this->Installed = true;
    auto* const menu = new QMenu(tr("Haptics"), browser->contextMenu());
    menu->setObjectName("hapticSourceMenu");
    menu->setToolTipsVisible(true);
    this->fill(menu);
    browser->contextMenu()->addSeparator();
    browser->contextMenu()->addMenu(menu);
  }
}

void pqHapticSourceMenu::addKind(QMenu* menu, const char* name, const QString& title, const QString& kind)
{
  QAction* const action = menu->addAction(title);
  action->setObjectName(name);
  this->connect(action, &QAction::triggered, this,
    [this, kind] { this->Controller->kinds()->touchAs(pqActiveObjects::instance().activeSource(), kind); });
}

void pqHapticSourceMenu::fill(QMenu* menu)
{
  QAction* const likely = menu->addAction(tr("Touch"));
  likely->setObjectName("hapticTouchSource");
  likely->setToolTip(tr("Touch, with this source as the kind that is most likely for its data"));
  this->connect(likely, &QAction::triggered, this,
    [this] { this->Controller->kinds()->touch(pqActiveObjects::instance().activeSource()); });
  menu->addSeparator();
  this->addKind(menu, "hapticAsSurface", tr("Touch as Surface"), "surface");
  this->addKind(menu, "hapticAsLines", tr("Touch as Lines"), "lines");
  this->addKind(menu, "hapticAsField", tr("Touch as Field"), "field");
  this->addKind(menu, "hapticAsTool", tr("Touch as Tool"), "tool");
  this->addKind(menu, "hapticAsTissue", tr("Touch as Tissue"), "tissue");
  this->addKind(menu, "hapticAsMechanism", tr("Touch as Mechanism"), "mechanism");
  this->addKind(menu, "hapticNotAtAll", tr("Touch Not at All"), "not at all");
}
