// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticStarter.h"

#include "pqApplicationCore.h"
#include "pqEventPlayer.h"
#include "pqHapticController.h"
#include "pqHapticEventPlayer.h"
#include "pqHapticMeasuring.h"
#include "pqHapticSourceMenu.h"
#include "pqTestUtility.h"

pqHapticStarter::pqHapticStarter(QObject* parent) : Superclass(parent) {}

pqHapticStarter::~pqHapticStarter() = default;

void pqHapticStarter::onStartup()
{
  auto* controller = pqHapticController::instance();
  new pqHapticSourceMenu(controller);
  new pqHapticMeasuring(controller);
  pqEventPlayer* player = pqApplicationCore::instance()->testUtility()->eventPlayer();
  player->addWidgetEventPlayer(new pqHapticEventPlayer(controller, player));
}

void pqHapticStarter::onShutdown()
{
  pqHapticController::instance()->shutdown();
}
