// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticStatusBar_h
#define pqHapticStatusBar_h

#include "pqCoreUtilities.h"

#include <QMainWindow>
#include <QStatusBar>
#include <QString>

/// Says a sentence in ParaView's status bar for 15 s, long enough to be read after a look at the view, or for another
/// time; 0: until the next one. "" takes the sentence back.
inline void pqHapticSayInStatusBar(const QString& sentence, int said_ms = 15000)
{
  if (auto* const window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget()))
  {
    window->statusBar()->showMessage(sentence, said_ms);
  }
}

#endif
