// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMenu_h
#define pqHapticMenu_h

#include <QActionGroup>

/// The menu "Haptics": touch, let go, show the panel, labyrinths, the guide.
class pqHapticMenu : public QActionGroup
{
  Q_OBJECT
  typedef QActionGroup Superclass;

public:
  explicit pqHapticMenu(QObject* parent);
};

#endif
