// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticEventPlayer_h
#define pqHapticEventPlayer_h

#include "pqWidgetEventPlayer.h"

class pqHapticController;

/**
 * Test events of our own, so that a test script can move the hand and wait without blocking the event loop:
 *
 *   hapticPose  "x,y,z"       the fed device's position in scene coordinates [u]
 *   hapticWait  "ms"          processes events for that long
 *   hapticCheck "name,low,high"  fails unless a read-out of the session lies in [low, high]
 *
 * Q_OBJECT is required: ParaView keys players by class name.
 */
class pqHapticEventPlayer : public pqWidgetEventPlayer
{
  Q_OBJECT
  typedef pqWidgetEventPlayer Superclass;

public:
  explicit pqHapticEventPlayer(pqHapticController* controller, QObject* parent = nullptr);
  using Superclass::playEvent;
  bool playEvent(QObject* object, const QString& command, const QString& arguments, bool& error) override;

private:
  bool pose(const QString& arguments);
  bool check(const QString& arguments);

  pqHapticController* Controller;
};

#endif
