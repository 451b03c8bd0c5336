// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticSourceMenu_h
#define pqHapticSourceMenu_h

#include <QObject>

class QMenu;
class pqHapticController;

/// The submenu "Haptics" in the context menu of the pipeline browser: how the active source is touched.
class pqHapticSourceMenu : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticSourceMenu(pqHapticController* controller);

private:
  /// The main window may get its pipeline browser after the plugin is loaded.
  void install();
  void fill(QMenu* menu);
  void addKind(QMenu* menu, const char* name, const QString& title, const QString& kind);

  pqHapticController* Controller;
  bool Installed = false;
};

#endif
