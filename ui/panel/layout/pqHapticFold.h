// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticFold_h
#define pqHapticFold_h

#include <QToolButton>

/// A button of the panel that unfolds a widget elsewhere in it, folded at first.
class pqHapticFold : public QToolButton
{
  Q_OBJECT
  typedef QToolButton Superclass;

public:
  /// Named like the folded widget, and "Button".
  pqHapticFold(QWidget* folded, const QString& title, const QString& tip);
};

#endif
