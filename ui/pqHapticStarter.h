// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticStarter_h
#define pqHapticStarter_h

#include <QObject>

/// Brings the haptics of the client up when the plugin is loaded and lets go before the client ends.
class pqHapticStarter : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticStarter(QObject* parent = nullptr);
  ~pqHapticStarter() override;

  void onStartup();
  void onShutdown();
};

#endif
